// The part of the card table that brings a model to rest and drives or opens its sides:
// LOCDAMP, KINDAMP, MSCALE, SOLVE, SAVE, INSITU, SERVO (docs/rest.md), QUIET
// (docs/waves.md).
#pragma once

#include <vector>

#include "deck/cards/card_table.hpp"

namespace blocks::deck {

/// Returns these cards. Use card_table() to read them.
std::vector<CardSpec> rest_cards();

}  // namespace blocks::deck
