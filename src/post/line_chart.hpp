// Curves over a common axis: histories and profiles. One panel for each quantity.
#pragma once

#include <string>
#include <vector>

namespace blocks::post {

/// Points that are not finite interrupt the line.
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

/// Draws a PNG, SVG or PDF file by the path's ending. width: pixels or points. Throws
/// std::runtime_error: unknown ending, nothing to draw, file not writable.
void draw_chart(const std::string& path, const Chart& chart, double width);

}  // namespace blocks::post
