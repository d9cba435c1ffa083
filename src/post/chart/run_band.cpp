#include "post/chart/run_band.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "quantities/statistic.hpp"

namespace blocks::post {

using namespace draw;

namespace {

/// Returns y at x, linear between the points; NaN outside them.
double value_at(const ChartLine& line, double x) {
  const auto right = std::lower_bound(line.x.begin(), line.x.end(), x);
  if (right == line.x.end())
    return std::nan("");
  const auto i = static_cast<std::size_t>(right - line.x.begin());
  if (*right == x)
    return line.y[i];
  if (i == 0)
    return std::nan("");
  const double share = (x - line.x[i - 1]) / (line.x[i] - line.x[i - 1]);
  return line.y[i - 1] + share * (line.y[i] - line.y[i - 1]);
}

/// Returns the x of the line with most points between `from` and `to`, and these ends.
std::vector<double> common_points(const std::vector<ChartLine>& lines, double from,
                                  double to) {
  const auto& finest = *std::max_element(
      lines.begin(), lines.end(),
      [](const ChartLine& a, const ChartLine& b) { return a.x.size() < b.x.size(); });
  std::vector<double> points = {from};
  for (const double x : finest.x)
    if (x > from && x < to)
      points.push_back(x);
  if (to > from)
    points.push_back(to);
  return points;
}

double percentile(double percent, std::vector<double>& values) {
  return quantities::reduce({quantities::Statistic::How::percentile, percent}, values);
}

}  // namespace

ChartLine band_of(const std::vector<ChartLine>& lines) {
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (const ChartLine& line : lines) {
    from = std::max(from, line.x.front());
    to = std::min(to, line.x.back());
  }
  if (!(from <= to))
    throw std::runtime_error("the runs have no common range for a band; draw their "
                             "curves with --each-run");
  ChartLine band;
  for (const double x : common_points(lines, from, to)) {
    std::vector<double> values;
    for (const ChartLine& line : lines)
      if (const double y = value_at(line, x); std::isfinite(y))
        values.push_back(y);
    const bool none = values.empty();
    band.x.push_back(x);
    band.y.push_back(none ? std::nan("") : percentile(50.0, values));
    band.low.push_back(none ? std::nan("") : percentile(band_low, values));
    band.high.push_back(none ? std::nan("") : percentile(band_high, values));
  }
  return band;
}

}  // namespace blocks::post
