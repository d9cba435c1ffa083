#include "geometry/block_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace blocks::geometry {
namespace {

/// Second moments of area about the centroid, [L^4].
struct SecondMoments {
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

SecondMoments second_moments(const Polygon& outline, double& area) {
  double twice_area = 0.0;
  Vec2 first = Vec2::Zero();
  SecondMoments m;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Vec2 a = outline[i] - outline[0];
    const Vec2 b = outline[i + 1] - outline[0];
    const double triangle = cross(b, a);
    const auto product = [&](int j, int k) {
      return triangle *
             (2.0 * a[j] * a[k] + 2.0 * b[j] * b[k] + a[j] * b[k] + b[j] * a[k]);
    };
    twice_area += triangle;
    first += triangle * (a + b);
    m.xx += product(0, 0) / 24.0;
    m.xy += product(0, 1) / 24.0;
    m.yy += product(1, 1) / 24.0;
  }
  area = 0.5 * twice_area;
  const Vec2 centre = first / (3.0 * twice_area);
  m.xx -= area * centre.x() * centre.x();
  m.xy -= area * centre.x() * centre.y();
  m.yy -= area * centre.y() * centre.y();
  return m;
}

}  // namespace

BlockShape measure_shape(const Polygon& outline) {
  BlockShape shape;
  const SecondMoments m = second_moments(outline, shape.area);
  const double mean = 0.5 * (m.xx + m.yy);
  const double spread = std::hypot(0.5 * (m.xx - m.yy), m.xy);
  // In a very thin block the smaller moment is lost in round-off; 4 eps of the mean
  // bounds it.
  const double smaller =
      std::max(mean - spread, 4.0 * std::numeric_limits<double>::epsilon() * mean);
  shape.aspect = std::sqrt((mean + spread) / smaller);
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
