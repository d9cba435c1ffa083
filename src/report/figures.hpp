// The figures of a report, as SVG for its page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/analysis.hpp"
#include "report/ensemble.hpp"

namespace blocks::report {

/// The width of a figure on the page.
enum class FigureWidth { whole, half };

/// Returns the median and the band of the profiles of the groups; empty if there is no
/// profile. At most most_groups_drawn groups are drawn.
std::string profile_figure(const Ensemble& ensemble, const Analysis& analysis);

/// Returns the histogram of a measure, one panel for each group; empty if it has fewer
/// than two values, or for a share.
std::string histogram(const Ensemble& ensemble, const Analysis& analysis,
                      std::size_t column, FigureWidth width);

/// Returns the means of a measure against the numbers of the parameter that varies,
/// with their intervals; empty if there is no such parameter.
std::string against_parameter(const Ensemble& ensemble, const Analysis& analysis,
                              std::size_t column, FigureWidth width);

/// Returns the paired differences from the first value of the parameter, with their
/// intervals; empty if there are none.
std::string differences_figure(const Ensemble& ensemble, const Analysis& analysis,
                               std::size_t column, FigureWidth width);

/// Returns the first and the last picture of a run.
std::string first_and_last(const Ensemble& ensemble, const RunRow& row,
                           const std::optional<double>& mirror);

/// Returns the last picture of a run.
std::string last_picture(const Ensemble& ensemble, const RunRow& row);

/// The most groups in one figure of profiles or histograms.
inline constexpr std::size_t most_groups_drawn = 6;

/// The boundaries of bins: round numbers, at least one bin. The width follows Freedman
/// and Diaconis (1981), 2 (q75 - q25) / n^(1/3), within 5 to 40 bins. Whole numbers
/// have bins around them.
std::vector<double> bin_boundaries(std::vector<double> values);

}  // namespace blocks::report
