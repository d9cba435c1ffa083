// The contact predicates in plain doubles: the formulas of the header of the same name
// without bounds, wrong now and then. Only to measure what exactness costs.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

inline constexpr double contact_slack = 1e-6;

namespace plain {

inline double area(const Vec2& c, const Vec2& o, const Vec2& p1, const Vec2& p2) {
  return (c.x() - o.x()) * (p2.y() - p1.y()) - (c.y() - o.y()) * (p2.x() - p1.x());
}

inline int sign(double x) { return int{x > 0} - int{x < 0}; }

}  // namespace plain

inline int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  return plain::sign(plain::area(c, p1, p1, p2));
}

inline bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  return plain::area(c, p1, p1, p2) + contact_slack * (p2 - p1).squaredNorm() >= 0;
}

inline bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const Vec2 e = p2 - p1;
  const double along = (c - p1).dot(e), length2 = e.squaredNorm();
  const double slack = contact_slack * length2;
  return along + slack >= 0 && length2 - along + slack >= 0;
}

inline bool within_depth(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                         const Vec2& p2) {
  return plain::area(c, centroid, p1, p2) <= 0;
}

inline bool in_reach_of_edge(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                             const Vec2& p2) {
  return near_or_inside(c, p1, p2) && between(c, p1, p2) &&
         within_depth(c, centroid, p1, p2);
}

inline bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                       const Vec2& p2) {
  const Vec2 e = p2 - p1, t = neighbour - c;
  const double sine = cross(e, t);
  return sine * std::abs(sine) +
             0.030153689607045807973 * (e.squaredNorm() * t.squaredNorm()) >=
         0;
}

inline int compare_depth(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& q1,
                         const Vec2& q2) {
  return plain::sign(plain::area(c, p1, p1, p2) * (q2 - q1).norm() -
                     plain::area(c, q1, q1, q2) * (p2 - p1).norm());
}

namespace exact {
/// None is left to exact arithmetic here.
inline unsigned long long calls() { return 0; }
}  // namespace exact

}  // namespace blocks::geometry
