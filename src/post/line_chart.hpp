// Curves over a common axis, for histories and profiles; one panel for each quantity.
#pragma once

#include <string>
#include <vector>

#include "post/page_size.hpp"

namespace blocks::post {

/// A curve, with a band around it if there are ends of one. Points that are not finite
/// interrupt the line. The vectors have the same length, or `low` and `high` are empty.
struct ChartLine {
  std::string legend;
  std::vector<double> x, y;
  std::vector<double> low = {}, high = {};
  std::string band_legend = {};  ///< of the band
};

struct ChartPanel {
  std::string y_label;  ///< with the unit
  std::vector<ChartLine> lines;
};

struct Chart {
  std::string title, subtitle;
  std::string x_label;  ///< with the unit
  std::vector<ChartPanel> panels;
};

/// Draws a PNG, SVG or PDF file, depending on the extension. Throws
/// std::runtime_error if the extension is unknown, there is nothing to draw, the page
/// is too small, or the file cannot be written.
void draw_chart(const std::string& path, const Chart& chart, const PageSize& page);

}  // namespace blocks::post
