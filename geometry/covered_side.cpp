// The quick half of the question, in doubles: most sides are certainly not covered.
#include "geometry/covered_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks::geometry {
namespace {

const Vec2& start_of(Outline polygon, std::size_t side) { return polygon[side]; }
const Vec2& end_of(Outline polygon, std::size_t side) {
  return polygon[side + 1 < polygon.size() ? side + 1 : 0];
}

/// The largest distance from a point to a corner, and the shortest side, both [L] and
/// with the sums of components for the lengths: from above and from below.
struct Extent {
  double farthest = 0.0, shortest = std::numeric_limits<double>::infinity();

  void include(Outline polygon, const Vec2& from) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      farthest = std::max(farthest, (polygon[k] - from).lpNorm<1>());
      shortest = std::min(
          shortest,
          (end_of(polygon, k) - start_of(polygon, k)).lpNorm<Eigen::Infinity>());
    }
  }
};

/// Between two bounds.
struct Range {
  double low, high;
};

/// The part of a side behind some lines, from the depths of its two ends below each, 0
/// to 1 along the side. Depths may be wrong by `error`.
struct PartBehind {
  Range from = {0.0, 0.0}, to = {1.0, 1.0};

  void cut(double first, double last, double error) {
    const auto zero = [](double a, double b) { return a / (a - b); };
    const double first_low = first - error, first_high = first + error;
    const double last_low = last - error, last_high = last + error;
    if (first_low > 0.0 && last_low < 0.0)
      to.low = std::min(to.low, zero(first_low, last_low));
    if (first_high > 0.0 && last_high < 0.0)
      to.high = std::min(to.high, zero(first_high, last_high));
    if (first_low < 0.0 && last_low > 0.0)
      from.high = std::max(from.high, zero(first_low, last_low));
    if (first_high < 0.0 && last_high > 0.0)
      from.low = std::max(from.low, zero(first_high, last_high));
    if (first_low <= 0.0 && last_low <= 0.0)
      from.high = 1.0, to.low = 0.0;
    if (first_high < 0.0 && last_high < 0.0)
      from.low = 1.0, to.high = 0.0;
  }
};

}  // namespace

bool is_surely_uncovered(const SideEnd& end, Outline other,
                         std::span<const Outline> neighbours, double room) {
  const auto side = static_cast<std::size_t>(end.side);
  const Vec2 first = start_of(end.polygon, side);
  const Vec2 edge = end_of(end.polygon, side) - first;
  const double length = edge.norm();
  const Vec2 along = edge / length;
  Extent extent;
  extent.include(end.polygon, first);
  extent.include(other, first);
  for (const Outline& neighbour : neighbours)
    extent.include(neighbour, first);
  // A unit vector along a side of length l turns by less than 2 room / l. Rounding
  // errors of a distance are below 1e-15 of the farthest point over the shortest side.
  const double spread = extent.farthest / extent.shortest;
  const double error =
      1e-12 * (1.0 + spread) * extent.farthest + room * (3.0 + 6.0 * spread);
  if (!(error < 1e-2 * extent.shortest))
    return false;

  PartBehind interval;
  for (std::size_t k = 0; k < other.size(); ++k) {
    const Vec2 line = (end_of(other, k) - start_of(other, k)).normalized();
    const double depth = cross(first - start_of(other, k), line);
    interval.cut(depth, depth + cross(edge, line), error);
  }
  if (interval.from.low > interval.to.high)
    return true;
  const Range h = end.at_start
                      ? Range{length * interval.to.low, length * interval.to.high}
                      : Range{length - length * interval.from.high,
                              length - length * interval.from.low};
  const Range stretch =
      end.at_start ? Range{0.0, h.high} : Range{length - h.high, length};

  double covered = 0.0;
  for (const Outline& neighbour : neighbours)
    for (std::size_t f = 0; f < neighbour.size(); ++f) {
      const Vec2 &near = end_of(neighbour, f), &far = start_of(neighbour, f);
      const Vec2 across = far - near;  // runs along the side if the two face each other
      const double product = across.dot(along), of_across = across.norm();
      if (product < 0.9 * of_across)  // the cosine of 10 degrees is .985
        continue;
      const double begin = (near - first).dot(along);
      const double common = std::min(begin + product, stretch.high) -
                            std::max(begin, stretch.low) + 4.0 * error;
      if (common <= 0.0)
        continue;
      double reach = -std::numeric_limits<double>::infinity();
      for (const Vec2& corner : other)
        reach = std::max(reach, cross(across, corner - far) / of_across);
      const double gap =
          std::min(cross(along, near - first), cross(along, far - first));
      if (reach + error >= h.low && gap - error <= h.high)
        covered += common;
    }
  return covered < 0.5 * h.low;
}

}  // namespace blocks::geometry
