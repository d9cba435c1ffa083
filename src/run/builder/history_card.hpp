// Reads the quantities of the HISTORY card.
#pragma once

#include <vector>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "model/settings.hpp"
#include "quantities/curve_values.hpp"

namespace blocks::run {

/// A quantity of the card and its place in the deck.
struct NamedCurve {
  quantities::Curve curve;
  deck::SourceLocation where;
};

/// Returns the quantities of a HISTORY card, or the usual ones if it names none.
/// Reports quantities that cannot be read or are named twice.
std::vector<NamedCurve> named_curves(const deck::Command& command,
                                     deck::Diagnostics& diagnostics);

/// The numbers of the materials that have names.
quantities::MaterialNumbers material_numbers(const Settings& settings);

}  // namespace blocks::run
