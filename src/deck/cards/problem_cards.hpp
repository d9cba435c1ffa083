// The part of the card table that defines the problem (report A.2).
#pragma once

#include <vector>

#include "deck/cards/card_table.hpp"

namespace blocks::deck {

/// Returns the cards of A.2 in the order of the report. Use card_table() to read them.
std::vector<CardSpec> problem_cards();

}  // namespace blocks::deck
