// Where the rose, its legend and the histograms of a figure are on its page.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "draw/chart/histogram.hpp"
#include "draw/chart/rose.hpp"
#include "draw/page_size.hpp"
#include "draw/pen.hpp"

namespace blocks::draw {

/// The places on the page [units]. Histograms are side by side, or below each other on
/// a narrow page.
struct RoseLayout {
  /// `legend_high` is the height of the legend. Throws std::runtime_error if the page
  /// is too small.
  RoseLayout(double legend_high, std::size_t histograms, const PageSize& page,
             bool titled);

  bool is_narrow = false;
  double left = 0, title = 0, subtitle = 0, height = 0;
  RosePlace rose{};
  double legend_left = 0, legend_top = 0, legend_wide = 0;
  std::vector<HistogramPlace> plots;
};

/// Paints the page and writes its heading and the line below it.
void draw_heading(Pen& pen, const RoseLayout& layout, const PageSize& page,
                  const std::string& heading, const std::string& subtitle);

}  // namespace blocks::draw
