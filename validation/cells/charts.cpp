#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/zeta.hpp>
#include <cmath>
#include <numbers>

#include "draw/chart/line_chart.hpp"
#include "validation/cells/figures.hpp"

namespace blocks::validation {
namespace {

using draw::Chart;
using draw::ChartLine;
using draw::ChartPanel;
using std::numbers::pi;

constexpr double percent = 100.0;

std::size_t find_case(const Study& study, const std::string& group) {
  const auto found = std::find_if(study.cases.begin(), study.cases.end(),
                                  [&](const Case& one) { return one.group == group; });
  return static_cast<std::size_t>(found - study.cases.begin());
}

Sums total(const Study& study, std::size_t index) {
  Sums result = Sums::Zero(sum::count);
  for (const auto& set : study.samples[index])
    for (const Sums& one : set)
      result += one;
  return result;
}

ChartPanel side_panel(const Study& study, const std::string& group,
                      const std::string& label, const std::vector<double>& x,
                      const std::vector<double>& exact) {
  const Sums sums = total(study, find_case(study, group));
  ChartLine bars{"measured", {}, {}};
  for (int n = 3; n <= 12; ++n) {
    bars.x.push_back(n);
    bars.y.push_back(percent * sums[sum::first_side_bin + n] / sums[sum::cells]);
  }
  bars.form = ChartLine::Form::bars;
  bars.bar = 0.8;
  ChartLine known{"exact", x, exact};
  for (double& y : known.y)
    y *= percent;
  known.form = ChartLine::Form::intervals;
  return {label, {bars, known}};
}

// Distribution function of the area over its mean, for two sets of exponential
// spacings.
double exponential_law(double t) {
  const double root = 2.0 * std::sqrt(t);
  return t > 0.0 ? 1.0 - root * boost::math::cyl_bessel_k(1, root) : 0.0;
}

// The same for two sets of spacings that are uniform between 1 and 3.
double uniform_law(double t) {
  const double c = std::clamp(4.0 * t, 1.0, 9.0);
  return c < 3.0 ? (c * std::log(c) - c + 1.0) / 4.0
                 : (c - 5.0 + c * std::log(9.0 / c)) / 4.0;
}

double gamma_law(double t) {
  constexpr double variance = 0.28018;
  return t > 0.0 ? cdf(boost::math::gamma_distribution<>(1.0 / variance, variance), t)
                 : 0.0;
}

ChartPanel area_panel(const Study& study, const std::string& group,
                      const std::string& label, const std::string& law_name,
                      double (*law)(double)) {
  const Sums sums = total(study, find_case(study, group));
  ChartLine bars{"measured", {}, {}};
  for (int k = 0; k < sum::area_bins; ++k) {
    bars.x.push_back((k + 0.5) * sum::area_bin_width);
    bars.y.push_back(percent * sums[sum::first_area_bin + k] / sums[sum::cells]);
  }
  bars.form = ChartLine::Form::bars;
  bars.bar = sum::area_bin_width;
  ChartLine curve{law_name, {}, {}};
  constexpr int points = 391;
  constexpr double half = sum::area_bin_width / 2.0, step = 0.01;
  for (int k = 0; k < points; ++k) {
    const double t = half + step * k;
    curve.x.push_back(t);
    curve.y.push_back(percent * (law(t + half) - law(t - half)));
  }
  return {label, {bars, curve}};
}

/// Draws how one number of a network is distributed over the networks of a case.
ChartPanel network_panel(const Study& study, const Row& row, int index, double bar) {
  std::vector<double> values;
  for (const auto& set : study.samples[row.index])
    for (const Sums& one : set)
      values.push_back(one[index]);
  const double low = std::floor(*std::min_element(values.begin(), values.end()) / bar);
  ChartLine bars{"networks", {}, {}};
  bars.form = ChartLine::Form::bars;
  bars.bar = bar;
  for (const double value : values) {
    const auto k = static_cast<std::size_t>(std::floor(value / bar) - low);
    while (bars.x.size() <= k) {
      bars.x.push_back((low + static_cast<double>(bars.x.size()) + 0.5) * bar);
      bars.y.push_back(0.0);
    }
    bars.y[k] += 1.0;
  }
  const double exact = row.quantity.exact;
  ChartLine mark{fmt::format("exact mean {:.4g}", exact), {exact}, {0.0}};
  mark.form = ChartLine::Form::mark;
  return {study.cases[row.index].name, {bars, mark}};
}

void draw_network_chart(const Study& study, const std::string& path, Chart chart,
                        const std::string& quantity, const std::string& kind, int index,
                        double bar) {
  for (const Row& row : study.rows)
    if (row.quantity.name == quantity && study.cases[row.index].name.ends_with(kind))
      chart.panels.push_back(network_panel(study, row, index, bar));
  draw_chart(path, chart, draw::PageSize());
}

}  // namespace

void draw_distributions(const Study& study, const std::string& folder) {
  const double quadrangles = pi * pi * std::numbers::ln2 - 1.0 / 3 - 7 * pi * pi / 36 -
                             3.5 * boost::math::zeta(3.0);
  Chart sides{"Number of sides of a cell", "", "sides", {}};
  sides.panels = {side_panel(study, "Poisson lines", "Poisson lines: cells [%]", {3, 4},
                             {2 - pi * pi / 6, quadrangles}),
                  side_panel(study, "Poisson Voronoi cells", "Voronoi: cells [%]", {3},
                             {0.0112400})};
  draw_chart(folder + "/sides.svg", sides, draw::PageSize());

  Chart areas{"Area of a cell", "", "area in units of its exact mean", {}};
  areas.panels = {area_panel(study, "Two NEGEXP sets", "NEGEXP: cells [%]", "exact law",
                             exponential_law),
                  area_panel(study, "Two UNIFORM sets", "UNIFORM: cells [%]",
                             "exact law", uniform_law),
                  area_panel(study, "Poisson Voronoi cells", "Voronoi: cells [%]",
                             "gamma law, approximate", gamma_law)};
  draw_chart(folder + "/areas.svg", areas, draw::PageSize());

  draw_network_chart(study, folder + "/faces.svg",
                     {"Number of cells in a window",
                      "Poisson lines in three convex windows",
                      "cells of a network",
                      {}},
                     "E faces", "", sum::faces, 10.0);
  draw_network_chart(study, folder + "/p21.svg",
                     {"Length of joints per area",
                      "trace 3, gap 2, space 0.5, with half ranges; before pruning",
                      "P21 of a network",
                      {}},
                     "P21 before pruning", "half ranges", sum::p21, 0.02);
}

}  // namespace blocks::validation
