// The charts of a report. A chart that has nothing to show has no panels.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "draw/chart/dot_chart.hpp"
#include "draw/chart/line_chart.hpp"
#include "report/analysis.hpp"
#include "report/ensemble.hpp"

namespace blocks::report {

/// Returns the median and the band of the profiles of the groups; empty if there is no
/// profile. At most max_groups_drawn groups are drawn.
draw::Chart profile_chart(const Ensemble& ensemble, const Analysis& analysis);

/// Returns the histogram of a measure, one panel for each group; empty if it has fewer
/// than two values, or for a share.
draw::Chart histogram(const Ensemble& ensemble, const Analysis& analysis,
                      std::size_t column);

/// Returns the means of a measure against the numbers of the parameter that varies,
/// with their intervals; empty if there is no such parameter.
draw::Chart against_parameter(const Ensemble& ensemble, const Analysis& analysis,
                              std::size_t column);

/// Returns the paired differences from the first value of the parameter, with their
/// intervals; empty if there are none.
draw::Chart differences(const Ensemble& ensemble, const Analysis& analysis,
                        std::size_t column);

/// Returns the Sobol indices of a measure in one of analysis.sensitivities; without
/// rows if none is a number.
draw::DotChart index_chart(const Ensemble& ensemble, const Sensitivity& sensitivity,
                           std::size_t column);

/// The most groups in one figure of profiles or histograms.
inline constexpr std::size_t max_groups_drawn = 6;

/// The boundaries of bins: round numbers, at least one bin. The width follows Freedman
/// and Diaconis (1981), 2 (q75 - q25) / n^(1/3), within 5 to 40 bins. Whole numbers
/// have bins around them.
std::vector<double> bin_boundaries(std::vector<double> values);

/// A chart with the name of its file, such as "histogram-dy-min".
struct NamedChart {
  std::string name;
  std::variant<draw::Chart, draw::DotChart> chart;
};

/// Returns all charts of the report that have something to show. Characters of
/// quantities other than letters, digits, '.' and '_' become '-' in the names.
std::vector<NamedChart> all_charts(const Ensemble& ensemble, const Analysis& analysis);

}  // namespace blocks::report
