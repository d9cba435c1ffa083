// A figure of a rose, its legend and histograms: where they are on its page.
#pragma once

#include <cstddef>
#include <functional>
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

struct RoseFigure {
  std::string heading, subtitle;
  Directions directions;
  std::function<std::string(int)> name_of;  ///< of a group of directions
  std::vector<Histogram> histograms;
  std::size_t first_plot = 0;  ///< of the histograms; those before it stay empty
};

/// Paints the page and draws the figure.
void draw_rose_figure(Pen& pen, const RoseLayout& layout, const PageSize& page,
                      const RoseFigure& figure);

/// Draws a figure to a PNG, SVG or PDF file, depending on the extension. Throws
/// std::runtime_error if the page is too small or the extension is unknown, and
/// files::FileError if the file cannot be written.
void draw_rose_figure(const std::string& path, const PageSize& page,
                      const RoseFigure& figure);

}  // namespace blocks::draw
