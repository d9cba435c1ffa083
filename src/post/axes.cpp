#include "post/axes.hpp"

#include <algorithm>
#include <cmath>

namespace blocks::post {

Axes::Axes(double x0, double x1, double y0, double y1, double page)
    : xmin(x0), xmax(x1), ymin(y0), ymax(y1), page_width(page) {
  const double unit = page / 1200.0;
  left = 84 * unit;
  top = 78 * unit;
  width = page - left - 150 * unit;
  // A flat or a tall model still gets a page one can look at.
  const double shape = std::clamp((ymax - ymin) / (xmax - xmin), 0.15, 1.4);
  height = width * shape;
  const double missing = shape * (xmax - xmin) - (ymax - ymin);
  if (missing > 0.0) {
    ymin -= 0.5 * missing;
    ymax += 0.5 * missing;
  } else {
    xmin += 0.5 * missing / shape;
    xmax -= 0.5 * missing / shape;
  }
  page_height = top + height + 64 * unit;
}

std::vector<double> nice_ticks(double lower, double upper, int count) {
  std::vector<double> ticks;
  const double span = upper - lower;
  if (!(span > 0.0) || !std::isfinite(span))
    return ticks;
  const double raw = span / count, power = std::pow(10.0, std::floor(std::log10(raw)));
  const double digit = raw / power;
  const double step = power * (digit < 1.5   ? 1
                               : digit < 3.5 ? 2
                               : digit < 7.5 ? 5
                                             : 10);
  for (double k = std::ceil(lower / step - 1e-9); k * step <= upper + 1e-9 * span; ++k)
    ticks.push_back(k * step == 0.0 ? 0.0 : k * step);
  return ticks;
}

}  // namespace blocks::post
