// Warns of units that cannot be converted, or that are those of another dimension.
#pragma once

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"

namespace blocks::run {

/// Adds a warning for each unit of a UNITS card that is not known in its place.
void check_units(const deck::Units& card, deck::Diagnostics& diagnostics);

}  // namespace blocks::run
