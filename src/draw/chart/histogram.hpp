// Histograms of the blocks between joints: area, aspect ratio and number of sides.
#pragma once

#include <string>
#include <vector>

#include "draw/pen.hpp"

namespace blocks::draw {

/// A histogram on a logarithmic axis, or of whole numbers.
struct Histogram {
  std::string label;               ///< of the axis, with the unit
  std::vector<double> values;      ///< > 0; not empty
  bool whole = false;              ///< whole numbers, with one bar for each
  std::string note;                ///< written above the histogram: "median 3.2 m²"
  std::string counted = "blocks";  ///< of what there are so many
};

/// The plot of a histogram on the page [units], and the space for its numbers.
struct HistogramPlace {
  double left, top, width, height;
  static constexpr double beside = 58, above = 26, below = 52;
};

void draw_histogram(Pen& pen, const HistogramPlace& place, const Histogram& histogram);

}  // namespace blocks::draw
