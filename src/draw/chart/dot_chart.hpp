// A chart of named values with intervals: one row for each name, and in it a point of
// each series with its interval along the common axis.
#pragma once

#include <string>
#include <vector>

#include "draw/page_size.hpp"

namespace blocks::draw {

/// The vectors have as many numbers as the chart has names. A value that is not finite
/// has no point, and an interval that is not finite has no bar.
struct DotSeries {
  std::string legend;
  std::vector<double> value, low, high;
};

struct DotChart {
  std::string x_label;
  std::vector<std::string> names;  ///< from top to bottom
  std::vector<DotSeries> series;
  double low = 0.0, high = 1.0;  ///< that the axis shows at least; low < high
};

/// Returns the chart as SVG. Throws std::runtime_error if the page is too small.
std::string chart_svg(const DotChart& chart, const PageSize& page);

/// Draws a PNG, SVG or PDF file, depending on the extension. Throws
/// std::runtime_error if the extension is unknown or the page is too small, and
/// files::FileError if the file cannot be written.
void draw_chart(const std::string& path, const DotChart& chart, const PageSize& page);

}  // namespace blocks::draw
