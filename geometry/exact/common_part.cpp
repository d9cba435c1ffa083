#include "geometry/exact/common_part.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "geometry/exact/kernels.hpp"
#include "geometry/exact/numbers.hpp"

namespace blocks::geometry::exact {
namespace {

using Outline = std::vector<Point>;

Outline exactly(const Polygon& polygon) {
  Outline outline;
  for (const Vec2& corner : polygon)
    outline.emplace_back(Rational(corner.x()), Rational(corner.y()));
  return outline;
}

/// Returns the part of `rest` on the inner side of all edges of p (Sutherland-Hodgman).
Outline clipped(const Outline& p, Outline rest) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point& a = p[i];
    const Vector edge = p[(i + 1) % p.size()] - a;
    Outline inside;
    for (std::size_t k = 0; k < rest.size(); ++k) {
      const Point &here = rest[k], &then = rest[(k + 1) % rest.size()];
      const Rational d = cross(here - a, edge), e = cross(then - a, edge);
      if (d >= 0)
        inside.push_back(here);
      if ((d > 0 && e < 0) || (d < 0 && e > 0))
        inside.push_back(here + (then - here) * (d / (d - e)));
    }
    rest = std::move(inside);
  }
  return rest;
}

/// Returns the least distance by which q reaches behind an edge of p.
double min_reach(const Polygon& p, const Outline& exact_p, const Outline& q) {
  double min = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t next = (i + 1) % p.size();
    const Vector edge = exact_p[next] - exact_p[i];
    Rational reach = 0;
    for (const Point& corner : q)
      reach = std::max(reach, cross(corner - exact_p[i], edge));
    min = std::min(min, nearest(reach) / Vec2(p[next] - p[i]).stableNorm());
  }
  return min;
}

}  // namespace

CommonPart common_part(const Polygon& p, const Polygon& q) {
  const Outline a = exactly(p), b = exactly(q), common = clipped(a, b);
  Rational twice = 0;
  Vector moment(0, 0);
  for (std::size_t i = 1; i + 1 < common.size(); ++i) {
    const Vector to = common[i] - common[0], then = common[i + 1] - common[0];
    const Rational part = cross(then, to);
    twice += part;
    moment = moment + (to + then) * part;
  }
  const Point centroid = common[0] + moment / (3 * twice);
  return {nearest(twice / 2), Vec2(nearest(centroid.x()), nearest(centroid.y())),
          std::min(min_reach(p, a, b), min_reach(q, b, a))};
}

}  // namespace blocks::geometry::exact
