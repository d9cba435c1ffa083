// What a sweep has done so far.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sweep/one_run.hpp"
#include "sweep/plan.hpp"
#include "sweep/progress.hpp"

namespace blocks::sweep {

/// Returns how many runs have each status, from their outcomes. Throws
/// output::FileError if one is damaged.
Counts count_runs(const std::string& folder, const Plan& plan);

/// Returns the runs from `first` to `last` that have still to be run, in order.
std::vector<std::size_t> open_runs(const std::string& folder, std::size_t first,
                                   std::size_t last, const RunChoice& choice);

/// Returns the text of `blocks sweep status`: the plan, the counts, and the first
/// failed runs with their messages.
std::string status_text(const std::string& folder, const Plan& plan);

}  // namespace blocks::sweep
