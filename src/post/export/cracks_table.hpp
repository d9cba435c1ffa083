// The cracks of a run as a table (docs/cracks.md#the-record).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/export/number_table.hpp"
#include "post/read/results_cracks.hpp"
#include "post/read/units.hpp"

namespace blocks::post {

/// Returns a row for each crack. `units` are those of the values, empty: [L], [T].
/// `all` adds the ends of the cut, the distance moved and the energies before and
/// after, which do not fit on a terminal.
NumberTable cracks_table(const std::vector<Crack>& cracks,
                         const std::optional<Units>& units, bool all);

}  // namespace blocks::post
