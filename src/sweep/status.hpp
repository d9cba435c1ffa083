// What a sweep has done so far.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sweep/plan.hpp"
#include "sweep/progress.hpp"

namespace blocks::sweep {

/// Runs from `first` to `last`, both included.
struct Range {
  std::size_t first = 1, last = 1;
};

/// Returns how many of these runs have each status, from their outcomes.
Counts count_runs(const std::string& folder, const Range& runs);

/// Returns those of these runs that have no outcome, in order.
std::vector<std::size_t> open_runs(const std::string& folder, const Range& runs);

/// Removes the outcomes of those of these runs that ended with an error or a limit of
/// time, or whose outcome is damaged, so that they continue. Throws output::FileError.
void reopen_failed_runs(const std::string& folder, const Range& runs);

/// Returns the text of `blocks sweep status`: the plan, the counts, and the first
/// failed runs with their messages.
std::string status_text(const std::string& folder, const Plan& plan);

}  // namespace blocks::sweep
