// The part of the card table that cuts a domain into blocks: OUTLINE, JSET, TRACES,
// VORONOI, CUT (docs/joints.md).
#pragma once

#include <vector>

#include "deck/cards/card_table.hpp"

namespace blocks::deck {

/// Returns the cards of a group OUTLINE ... CUT in their order. Use card_table() to
/// read them.
std::vector<CardSpec> joint_cards();

}  // namespace blocks::deck
