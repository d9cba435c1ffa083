// The half of the card table that defines the problem (report A.2).
#pragma once

#include <vector>

#include "deck/card_table.hpp"

namespace blocks::deck {

/// The cards of A.2 in the order of the report; read them through card_table().
std::vector<CardSpec> problem_cards();

}  // namespace blocks::deck
