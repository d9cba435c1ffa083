// The part of the card table that lets blocks split: CRACK and MDAMP (docs/cracks.md).
#pragma once

#include <vector>

#include "deck/cards/card_table.hpp"

namespace blocks::deck {

/// Returns these cards. Use card_table() to read them.
std::vector<CardSpec> crack_cards();

}  // namespace blocks::deck
