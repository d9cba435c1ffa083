// Writes fitted joint sets: as a deck, as text and as JSON.
#pragma once

#include <string>

#include "joints/set_fit.hpp"
#include "joints/trace_map.hpp"

namespace blocks::joints {

/// Returns a deck that makes blocks of the sets in the window of the map. The values of
/// materials, friction and gravity are examples; the comments say so and give the
/// intervals.
std::string fit_deck(const NetworkFit& fit, const TraceMap& map,
                     const Network& network);

/// Returns one row for each field of each set, with its interval, and the notes.
std::string fit_text(const NetworkFit& fit);

/// Returns {"name", "components_by_bic", "sets": [...]}.
std::string fit_json(const NetworkFit& fit, const TraceMap& map);

}  // namespace blocks::joints
