// The lists that a card takes from the lines below it: coordinates, widths, points of a
// function.
#pragma once

#include <optional>
#include <vector>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "deck/free_field.hpp"

namespace blocks::deck {

/// What START allows; empty if it has a fault.
struct StartMaxima {
  std::optional<long> blocks;   ///< nblok
  std::optional<long> corners;  ///< ncmx
};

/// Reads the lines `data` below a card into its lists. `end` is just after the card.
/// Returns false after a fault, which has been reported. A card without lists stays as
/// it is.
bool read_lists(Card& card, const std::vector<Line>& data, SourceLocation end,
                const StartMaxima& maxima, Diagnostics& diagnostics);

}  // namespace blocks::deck
