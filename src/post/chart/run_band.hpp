// Many runs of one problem as a median and a band.
#pragma once

#include <vector>

#include "draw/chart/line_chart.hpp"

namespace blocks::post {

/// The percentiles at the lower and the upper end of a band.
constexpr double band_low = 5.0, band_high = 95.0;

/// Returns the median of lines and the band between the percentiles. Each line has
/// increasing x. The points are those of the line with most points where all lines are
/// defined, and the others are interpolated between their points. A line without a
/// value at a point, such as that of a removed block, does not count there. Throws
/// std::runtime_error if the lines have no common x.
draw::ChartLine band_of(const std::vector<draw::ChartLine>& lines);

}  // namespace blocks::post
