// The page of each run, in its folder.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/analysis.hpp"
#include "report/ensemble.hpp"

namespace blocks::report {

/// More runs than these have no page of their own, only their log.
inline constexpr std::size_t max_summary_pages = 2000;

struct RunPages {
  /// (rows) the file that a run is shown in: its page, otherwise its log; empty if it
  /// has none.
  std::vector<std::string> files;
  std::string fault;  ///< why pages could not be written, or empty
};

/// Writes DIR/runs/.../NAME.html for the runs if it is missing, older than the outcome,
/// or was written with other units or another mirror. Up to `max_played` runs with
/// results have the page of `blocks view`, which plays the run. If there are more, only
/// the median and the extreme runs have it; the others have a page with the last
/// picture and the log. Runs without results have a page with the log. `chosen` are the
/// rows of the median runs.
RunPages write_run_pages(const Ensemble& ensemble, const Analysis& analysis,
                         const std::vector<std::size_t>& chosen,
                         std::size_t max_played);

}  // namespace blocks::report
