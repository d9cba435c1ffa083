#include "joints/window.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blocks::joints {

using geometry::Polygon;
using geometry::Vec2;

Vec2 unit_vector(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

namespace {

/// A side of the window between two offsets across the direction.
struct Side {
  double low, high;  ///< positions along the direction, at both offsets
};

/// Adds the integrals over a strip of width `dt` whose chord runs from c0 to c1.
void add_strip(double dt, double c0, double c1, double shortest, ChordMeasure& sum) {
  const double excess0 = c0 - shortest, excess1 = c1 - shortest;
  if (excess0 >= 0.0 && excess1 >= 0.0) {
    sum.width += dt;
    sum.area += 0.5 * dt * (excess0 + excess1);
  } else if (excess0 > 0.0 || excess1 > 0.0) {
    const double max = std::max(excess0, excess1);
    const double part = dt * max / std::abs(excess0 - excess1);
    sum.width += part;
    sum.area += 0.5 * part * max;
  }
}

}  // namespace

ChordMeasure chord_measure(const Polygon& window, double degrees, double shortest) {
  const Vec2 along = unit_vector(degrees), across(-along.y(), along.x());
  const Vec2 origin = window.front();
  std::vector<double> offsets;
  for (const Vec2& corner : window)
    offsets.push_back(across.dot(corner - origin));
  std::vector<double> cuts = offsets;
  std::sort(cuts.begin(), cuts.end());
  ChordMeasure sum;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double low = cuts[k], high = cuts[k + 1];
    if (!(low < high))
      continue;
    std::vector<Side> sides;
    for (std::size_t i = 0; i < window.size(); ++i) {
      const std::size_t j = (i + 1) % window.size();
      const double from = offsets[i], to = offsets[j];
      if (std::min(from, to) > low || std::max(from, to) < high)
        continue;
      const double u = along.dot(window[i] - origin), v = along.dot(window[j] - origin);
      const auto position = [&](double offset) {
        return u + (v - u) * (offset - from) / (to - from);
      };
      sides.push_back({position(low), position(high)});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return a.low + a.high < b.low + b.high;
    });
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
      add_strip(high - low, sides[i + 1].low - sides[i].low,
                sides[i + 1].high - sides[i].high, shortest, sum);
  }
  return sum;
}

std::vector<std::pair<double, double>> chords(const Polygon& window, const Vec2& from,
                                              const Vec2& along) {
  std::vector<double> places;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const Vec2 &p = window[i], &q = window[(i + 1) % window.size()];
    const double s = geometry::cross(along, p - from);
    const double t = geometry::cross(along, q - from);
    // A corner on the line is above it, so each passage of the line counts once.
    if ((s >= 0.0) == (t >= 0.0))
      continue;
    const Vec2 place = p + (q - p) * (s / (s - t));
    places.push_back(along.dot(place - from) / along.squaredNorm());
  }
  std::sort(places.begin(), places.end());
  std::vector<std::pair<double, double>> inside;
  for (std::size_t i = 0; i + 1 < places.size(); i += 2)
    inside.emplace_back(places[i], places[i + 1]);
  return inside;
}

}  // namespace blocks::joints
