#include "geometry/block_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/polygon.hpp"

namespace blocks::geometry {

BlockShape measure_shape(const Polygon& outline) {
  BlockShape shape;
  const SectionProperties section = section_properties(outline);
  shape.area = section.area;
  const Eigen::Vector3d& m = section.second_moment;
  const double smaller =
      smaller_moment(m, 4.0 * std::numeric_limits<double>::epsilon());
  const double larger = 0.5 * (m[0] + m[2]) + std::hypot(0.5 * (m[0] - m[2]), m[1]);
  shape.aspect = std::sqrt(larger / smaller);
  shape.shortest_edge = std::numeric_limits<double>::infinity();
  shape.smallest_angle = 360.0;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 ahead = outline[(i + 1) % n] - outline[i];
    const Vec2 behind = outline[(i + n - 1) % n] - outline[i];
    // The outline is clockwise, so the interior is on the right of `ahead`. The
    // interior angle is the clockwise rotation from `ahead` to `behind`.
    double angle = std::atan2(cross(ahead, behind), ahead.dot(behind));
    angle = angle > 0.0 ? 2.0 * std::numbers::pi - angle : -angle;
    angle *= 180.0 / std::numbers::pi;
    if (angle < shape.smallest_angle) {
      shape.smallest_angle = angle;
      shape.corner = static_cast<int>(i);
    }
    if (const double length = ahead.stableNorm(); length < shape.shortest_edge) {
      shape.shortest_edge = length;
      shape.edge = static_cast<int>(i);
    }
  }
  return shape;
}

double coarsest_ulp(const Polygon& outline) {
  double largest = 0.0;
  for (const Vec2& corner : outline)
    largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  return outline.empty()
             ? 0.0
             : std::nextafter(largest, std::numeric_limits<double>::infinity()) -
                   largest;
}

}  // namespace blocks::geometry
