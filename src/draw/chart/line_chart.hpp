// Curves, bars and points with intervals over a common axis, for histories, profiles
// and reports; one panel for each quantity.
#pragma once

#include <string>
#include <vector>

#include "draw/page_size.hpp"

namespace blocks::draw {

/// A curve, with a band around it if there are ends of one. Points that are not finite
/// interrupt the line. The vectors have the same length, or `low` and `high` are empty.
struct ChartLine {
  enum class Form {
    curve,      ///< a line; with points if there are few
    bars,       ///< bars from 0 to the count y, of the width `bar`, around x
    intervals,  ///< points with error bars from `low` to `high`, and a thin line
    mark        ///< a vertical line at x, through the panel; y does not matter
  };
  std::string legend;
  std::vector<double> x, y;
  std::vector<double> low = {}, high = {};
  std::string band_legend = {};  ///< of the band or the error bars; empty: none
  Form form = Form::curve;
  double bar = 0.0;  ///< width of bars, in units of x
};

struct ChartPanel {
  std::string y_label;  ///< with the unit
  std::vector<ChartLine> lines;
  /// The y axis is logarithmic if a curve has positive values. Other values are at its
  /// low end. Not for bars.
  bool logarithmic = false;
};

struct Chart {
  std::string title, subtitle;
  std::string x_label;  ///< with the unit
  std::vector<ChartPanel> panels;
};

/// Returns the chart as SVG. Throws std::runtime_error if there is nothing to draw, or
/// the page is too small.
std::string chart_svg(const Chart& chart, const PageSize& page);

/// Draws a PNG, SVG or PDF file, depending on the extension. Throws
/// std::runtime_error if the extension is unknown, there is nothing to draw, the page
/// is too small, or the file cannot be written.
void draw_chart(const std::string& path, const Chart& chart, const PageSize& page);

}  // namespace blocks::draw
