#include "draw/chart/chart_layout.hpp"

#include <algorithm>
#include <stdexcept>

namespace blocks::draw {

std::vector<ChartKey> keys_of(const ChartPanel& panel) {
  std::vector<ChartKey> keys;
  for (std::size_t i = 0; i < panel.lines.size(); ++i) {
    if (!panel.lines[i].legend.empty())
      keys.push_back({i, false, panel.lines[i].legend, panel.lines[i].form});
    if (!panel.lines[i].low.empty() && !panel.lines[i].band_legend.empty())
      keys.push_back({i, true, panel.lines[i].band_legend, panel.lines[i].form});
  }
  return keys;
}

namespace {

/// Returns whether some panel has a legend of few entries that are too long for a
/// column of this width beside the panel [units].
bool has_long_keys(const Chart& chart, double column) {
  constexpr std::size_t few = 3;  // more entries would push the panel down
  constexpr double letter = 0.6 * 13;
  return std::any_of(chart.panels.begin(), chart.panels.end(), [&](const auto& one) {
    const auto keys = keys_of(one);
    return keys.size() <= few &&
           std::any_of(keys.begin(), keys.end(), [&](const ChartKey& key) {
             return letter * static_cast<double>(key.words.size()) > column;
           });
  });
}

}  // namespace

double ChartLayout::keys(const ChartPanel& one) const {
  const std::size_t lines = std::min(keys_of(one).size(), max_keys);
  return keys_above ? static_cast<double>(lines) * key_line + 4 : 0.0;
}

ChartLayout::ChartLayout(const Chart& chart, const PageSize& size) : page(size.width) {
  constexpr double narrow = 620, flat = 0.62, min_panel = 50;
  if (size.printed) {
    constexpr double beside = 200.0, margins = 62.0;  // of the sample and the page
    keys_above = size.width < narrow || has_long_keys(chart, beside - margins);
    head = 54, between = 26, foot = 60, left = 84, right = keys_above ? 16.0 : beside;
    title = 24, subtitle = 44;
    panel = std::clamp(flat * (page - left - right), 120.0, 210.0);
  }
  if (chart.title.empty()) {
    head -= subtitle - title;
    subtitle = title;
  }
  if (chart.subtitle.empty())
    head -= 22;
  const auto n = static_cast<double>(chart.panels.size());
  double rest = head + (n - 1) * between + foot;
  for (const ChartPanel& one : chart.panels)
    rest += keys(one);
  if (size.height > 0.0)
    panel = (size.height - rest) / n;
  if (panel < min_panel || page - left - right < min_panel)
    throw std::runtime_error("the size leaves no room for the curves: choose a larger "
                             "size, or fewer quantities");
  page_height = rest + n * panel;
}

}  // namespace blocks::draw
