// What a sweep has done so far.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "sweep/plan.hpp"

namespace blocks::sweep {

/// Runs from `first` to `last`, both included.
struct Range {
  std::size_t first = 1, last = 1;
};

/// The number of runs with each status; the status of runs without outcome is "open".
using Counts = std::map<std::string, std::size_t>;

/// Returns the counts in one line, "done" first: "62 done, 1 unsound, 1 open".
std::string words_of(const Counts& counts);

/// Returns how many of these runs have each status, from their outcomes.
Counts count_runs(const std::string& folder, const Range& runs);

/// Returns those of these runs that have no outcome, in order.
std::vector<std::size_t> open_runs(const std::string& folder, const Range& runs);

/// Removes the outcomes of those of these runs that ended with an error or a limit of
/// time, or whose outcome is damaged, so that they continue. Throws files::FileError.
void reopen_failed_runs(const std::string& folder, const Range& runs);

/// Returns the text of `blocks sweep status`: the plan, the counts, and the first
/// failed runs with their messages.
std::string status_text(const std::string& folder, const Plan& plan);

}  // namespace blocks::sweep
