// Many runs of one problem as a median and a band.
#pragma once

#include <vector>

#include "post/line_chart.hpp"

namespace blocks::post {

/// The percentiles at the lower and the upper end of a band.
constexpr double band_low = 5.0, band_high = 95.0;

/// Returns the percentile, 0 <= percent <= 100, interpolated between the sorted values.
/// There is at least one value.
double percentile(std::vector<double> values, double percent);

/// Returns the median of lines and the band between the percentiles. Each line has
/// increasing x. The points are those of the line with most points where all lines are
/// defined, and the others are interpolated between their points. Throws
/// std::runtime_error if the lines have no common x.
ChartLine band_of(const std::vector<ChartLine>& lines);

}  // namespace blocks::post
