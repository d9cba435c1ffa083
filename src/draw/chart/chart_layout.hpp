// Where the panels and the legends of a chart are on its page.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "draw/chart/line_chart.hpp"

namespace blocks::draw {

/// An entry of a legend: a line, or the band of a line.
struct ChartKey {
  std::size_t line;
  bool is_band;
  const std::string& words;  ///< of the panel, which must outlive it
  ChartLine::Form form = ChartLine::Form::curve;
};

/// Returns the entries of the legend of a panel.
std::vector<ChartKey> keys_of(const ChartPanel& panel);

/// The places of the panels on the page [units].
struct ChartLayout {
  double head = 84, panel = 300, between = 34, foot = 66, left = 104, right = 270;
  double page = 1200, page_height = 0;
  double title = 34, subtitle = 62;
  bool keys_above = false;  ///< the legend of a panel is above it, not beside it
  static constexpr double key_line = 19;
  static constexpr std::size_t max_keys = 8;

  /// Throws std::runtime_error if the page is too small.
  ChartLayout(const Chart& chart, const PageSize& size);

  /// Returns the height of the legend above a panel.
  double keys(const ChartPanel& one) const;
};

}  // namespace blocks::draw
