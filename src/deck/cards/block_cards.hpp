// The part of the card table that makes blocks: CREATE, CLOOP, READ9, LAYER, ORIENT,
// MERGE.
#pragma once

#include <vector>

#include "deck/cards/card_table.hpp"

namespace blocks::deck {

/// Returns these cards in the order of the report, A.2.1 to A.2.6. Use card_table() to
/// read them.
std::vector<CardSpec> block_cards();

}  // namespace blocks::deck
