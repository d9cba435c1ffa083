// The curves of `blocks history` with their legends: one run, several runs, or a band
// of many runs.
#pragma once

#include <string>
#include <vector>

#include "draw/chart/line_chart.hpp"
#include "post/read/run_parts.hpp"

namespace blocks::post {

/// More runs than these are drawn as a band.
constexpr std::size_t max_single_runs = 8;

/// One curve of one run.
struct RunLine {
  std::string y_label;  ///< of the panel, with the unit
  std::string what;     ///< the same for all runs: "speed of block 9"
  std::string legend;   ///< of this run alone
  std::vector<double> x, y;
  bool logarithmic = false;  ///< as in ChartPanel
};

/// Returns the names of the runs in legends: "crater (seed 3)". The name is that of the
/// results, or their path if two runs have the same name. The seed is given if it
/// differs between the runs. Returns an empty name for a single run.
std::vector<std::string> run_names(const std::vector<RunParts>& runs);

/// Returns the legend of a curve and its run, whose name may be empty.
std::string legend_of(const std::string& curve, const std::string& run);

/// Returns the panels in the order of the lines. With `bands`, curves of more than
/// max_single_runs runs become a median and a band.
std::vector<draw::ChartPanel> panels_of(const std::vector<RunLine>& lines, bool bands);

}  // namespace blocks::post
