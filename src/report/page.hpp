// The page of a report: one HTML file with all figures, which opens from the file
// system and can be printed. It explains the sweep to readers who do not know the deck.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/analysis.hpp"
#include "report/ensemble.hpp"
#include "report/run_pages.hpp"

namespace blocks::report {

struct PageOptions {
  std::optional<std::string> title;  ///< empty: that of the deck
  std::string folder;                ///< of the page; links are relative to it
};

/// Returns the row of the median run of each group that is shown, by the first measure
/// that is not a share.
std::vector<std::size_t> typical_runs(const Ensemble& ensemble,
                                      const Analysis& analysis);

/// Returns the page.
std::string report_page(const Ensemble& ensemble, const Analysis& analysis,
                        const std::vector<std::size_t>& typical, const RunPages& runs,
                        const PageOptions& options);

}  // namespace blocks::report
