// Curves over a common axis, for histories and profiles; one panel for each quantity.
#pragma once

#include <string>
#include <vector>

#include "post/page_size.hpp"

namespace blocks::post {

/// A curve; points that are not finite interrupt the line.
struct ChartLine {
  std::string legend;
  std::vector<double> x, y;  ///< of equal length
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
