// The decisions of the contact check as signs of polynomials in the stored doubles:
// (19), "between the corners", the depth rule, (20) and the nearest edge (report 3.3,
// rules 9-12). An inline double filter with a proven error bound answers nearly always;
// what it cannot decide goes to exact arithmetic in geometry/exact. Proofs:
// docs/predicates.md.
//
//            n   outward normal, left of the edge
//            |
//   p1 ------+------> p2     edge of a clockwise block, e = p2 - p1
//        c                   corner below: penetrated
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// eps of rules 10 and 12, in edge lengths: the double nearest to 1e-6, taken as exact.
inline constexpr double contact_slack = 1e-6;

namespace exact {

/// The same decisions without a filter. Cold; for the filters below and for tests.
int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2);
bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2);
bool between(const Vec2& c, const Vec2& p1, const Vec2& p2);
bool within_depth(const Vec2& c, const Vec2& centroid, const Vec2& p1, const Vec2& p2);
bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1, const Vec2& p2);
int compare_depth(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& q1,
                  const Vec2& q2);

/// How often an exact decision was taken on this thread.
unsigned long long calls();

}  // namespace exact

namespace filter {

/// 9 units of round-off: no filtered polynomial below collects more than 8, relative to
/// the sum of the magnitudes of its terms.
inline constexpr double relative = 1e-15;
/// Far above anything that underflow can hide, far below anything that matters.
inline constexpr double absolute = 1e-290;

inline double bound(double magnitude) { return relative * magnitude + absolute; }

}  // namespace filter

/// Sign of 2A = (xc - x1)(y2 - y1) - (yc - y1)(x2 - x1), (19) on differences: 1 the
/// corner has penetrated the edge's line, 0 it lies on it, -1 outside. Laws: swapping
/// p1 and p2 changes the sign; cyclic shifts of (c, p1, p2) keep it.
inline int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const double a = (c.x() - p1.x()) * (p2.y() - p1.y());
  const double b = (c.y() - p1.y()) * (p2.x() - p1.x());
  const double det = a - b, bound = filter::bound(std::abs(a) + std::abs(b));
  if (det > bound)
    return 1;
  if (-det > bound)
    return -1;
  return exact::overlap_sign(c, p1, p2);
}

/// d >= -eps L: the corner is inside the edge's line or outside by the slack at most
/// (rule 12); 2A + eps L^2 >= 0. True on the limit.
inline bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const double ex = p2.x() - p1.x(), ey = p2.y() - p1.y();
  const double a = (c.x() - p1.x()) * ey, b = (c.y() - p1.y()) * ex;
  const double slack = contact_slack * (ex * ex + ey * ey);
  const double value = a - b + slack;
  const double bound = filter::bound(std::abs(a) + std::abs(b) + slack);
  if (value > bound)
    return true;
  if (-value > bound)
    return false;
  return exact::near_or_inside(c, p1, p2);
}

/// -eps L <= s <= (1 + eps) L, s along the edge from p1 (rule 10). True on the limits.
/// Law: swapping p1 and p2 changes nothing.
inline bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const double ex = p2.x() - p1.x(), ey = p2.y() - p1.y();
  const double sx = (c.x() - p1.x()) * ex, sy = (c.y() - p1.y()) * ey;
  const double square = ex * ex + ey * ey, slack = contact_slack * square;
  const double s = sx + sy;
  const double after_first = s + slack, before_second = square - s + slack;
  const double bound = filter::bound(std::abs(sx) + std::abs(sy) + square + slack);
  if (after_first > bound && before_second > bound)
    return true;
  if (-after_first > bound || -before_second > bound)
    return false;
  return exact::between(c, p1, p2);
}

/// The depth rule: the overlap of c is at most the distance of the edge from the
/// centroid of its own block (rule 9): (c - centroid) x e <= 0. True on the limit.
inline bool within_depth(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                         const Vec2& p2) {
  const double a = (c.x() - centroid.x()) * (p2.y() - p1.y());
  const double b = (c.y() - centroid.y()) * (p2.x() - p1.x());
  const double det = a - b, bound = filter::bound(std::abs(a) + std::abs(b));
  if (-det > bound)
    return true;
  if (det > bound)
    return false;
  return exact::within_depth(c, centroid, p1, p2);
}

/// near_or_inside, between and within_depth together, for the loop: one evaluation of
/// their common terms settles nearly every potential contact. Law: equal to
/// near_or_inside && between && within_depth.
inline bool in_reach_of_edge(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                             const Vec2& p2) {
  const double ex = p2.x() - p1.x(), ey = p2.y() - p1.y();
  const double wx = c.x() - p1.x(), wy = c.y() - p1.y();
  const double a = wx * ey, b = wy * ex, sx = wx * ex, sy = wy * ey, s = sx + sy;
  const double square = ex * ex + ey * ey, slack = contact_slack * square;
  const double depth_a = (c.x() - centroid.x()) * ey,
               depth_b = (c.y() - centroid.y()) * ex;
  // at least the bound of each of the three, whose magnitudes are parts of this sum
  const double bound =
      2.0 * filter::bound(std::abs(a) + std::abs(b) + std::abs(sx) + std::abs(sy) +
                          square + slack + std::abs(depth_a) + std::abs(depth_b));
  const double least = std::min(std::min(a - b + slack, depth_b - depth_a),
                                std::min(s + slack, square - s + slack));
  if (least < -bound)
    return false;
  if (least > bound)
    return true;
  return near_or_inside(c, p1, p2) && between(c, p1, p2) &&
         within_depth(c, centroid, p1, p2);
}

/// (20) for one of the corner's own edges, t = neighbour - c: t.n >= sin(-10 degrees)
/// |t|. Rational input never ties. Law: scaling t or e by a positive factor changes
/// nothing.
inline bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                       const Vec2& p2) {
  constexpr double sine = 0.17364817766693036;  // sin 10 degrees, rounded
  const double ex = p2.x() - p1.x(), ey = p2.y() - p1.y();
  const double tx = neighbour.x() - c.x(), ty = neighbour.y() - c.y();
  const double d = ex * ty - ey * tx;
  // |e| |t| lies between `least` and twice that
  const double least =
      std::max(std::abs(ex), std::abs(ey)) * std::max(std::abs(tx), std::abs(ty));
  if (least > 1e-140 && least < 1e140) {
    if (d > -0.17 * least)  // 0.17 < sin 10 degrees
      return true;
    if (d < -0.348 * least)  // 0.348 > 2 sin 10 degrees
      return false;
    const double length = std::sqrt((ex * ex + ey * ey) * (tx * tx + ty * ty));
    const double value = d + sine * length;
    if (std::abs(value) > filter::relative * length)
      return value > 0.0;
  }
  return exact::faces_edge(c, neighbour, p1, p2);
}

/// Sign of the depth of c below edge p minus its depth below edge q, d = 2A / L (rule
/// 12). Law: swapping the edges changes the sign.
inline int compare_depth(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& q1,
                         const Vec2& q2) {
  const double px = p2.x() - p1.x(), py = p2.y() - p1.y();
  const double qx = q2.x() - q1.x(), qy = q2.y() - q1.y();
  const double p_square = px * px + py * py, q_square = qx * qx + qy * qy;
  if (std::min(p_square, q_square) > 1e-200 && std::max(p_square, q_square) < 1e200) {
    const double pa = (c.x() - p1.x()) * py, pb = (c.y() - p1.y()) * px;
    const double qa = (c.x() - q1.x()) * qy, qb = (c.y() - q1.y()) * qx;
    const double p_length = std::sqrt(p_square), q_length = std::sqrt(q_square);
    const double value = (pa - pb) / p_length - (qa - qb) / q_length;
    const double magnitude = (std::abs(pa) + std::abs(pb)) / p_length +
                             (std::abs(qa) + std::abs(qb)) / q_length;
    const double bound = 1.3 * filter::relative * magnitude + 1e-180;
    if (value > bound)
      return 1;
    if (-value > bound)
      return -1;
  }
  return exact::compare_depth(c, p1, p2, q1, q2);
}

}  // namespace blocks::geometry
