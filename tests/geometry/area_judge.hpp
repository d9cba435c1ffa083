// The common area of two blocks by vertical slabs on rationals of boost. It is a slow
// and exact judge of geometry/overlap.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <utility>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::geometry::testing {

using Exact = boost::multiprecision::cpp_rational;

struct ExactPoint {
  Exact x, y;
};

/// Returns the corners as rationals.
inline std::vector<ExactPoint> exactly(const Polygon& outline) {
  std::vector<ExactPoint> points;
  for (const Vec2& p : outline)
    points.push_back({Exact(p.x()), Exact(p.y())});
  return points;
}

/// Returns the heights where the vertical line at x crosses a simple outline; x is not
/// that of a corner. The line is inside between heights 0 and 1, 2 and 3, and so on.
inline std::vector<Exact> heights_at(const std::vector<ExactPoint>& p, const Exact& x) {
  std::vector<Exact> heights;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const ExactPoint &a = p[i], &b = p[(i + 1) % p.size()];
    if ((a.x < x) != (b.x < x))
      heights.push_back(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// Returns the area of the intersection. Between two successive x of corners and
/// crossings the common height is linear. The area of a slab is its width times the
/// height at its middle.
inline Exact common_area(const Polygon& first, const Polygon& second) {
  const auto p = exactly(first), q = exactly(second);
  std::vector<Exact> cuts;
  for (const auto& a : p)
    cuts.push_back(a.x);
  for (const auto& a : q)
    cuts.push_back(a.x);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) {
      const ExactPoint &a = p[i], &b = p[(i + 1) % p.size()];
      const ExactPoint &c = q[j], &d = q[(j + 1) % q.size()];
      const Exact ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
      const Exact turn = ux * vy - uy * vx;
      if (turn == 0)
        continue;
      const Exact s = ((c.x - a.x) * vy - (c.y - a.y) * vx) / turn;
      if (s > 0 && s < 1)
        cuts.push_back(a.x + ux * s);
    }
  std::sort(cuts.begin(), cuts.end());
  Exact area = 0;
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    if (cuts[k - 1] == cuts[k])
      continue;
    const Exact middle = (cuts[k - 1] + cuts[k]) / 2;
    const auto u = heights_at(p, middle), v = heights_at(q, middle);
    for (std::size_t i = 0; i + 1 < u.size(); i += 2)
      for (std::size_t j = 0; j + 1 < v.size(); j += 2) {
        const Exact low = std::max(u[i], v[j]), high = std::min(u[i + 1], v[j + 1]);
        if (low < high)
          area += (high - low) * (cuts[k] - cuts[k - 1]);
      }
  }
  return area;
}

}  // namespace blocks::geometry::testing
