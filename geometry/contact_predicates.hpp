// The yes/no questions of the contact search (report 3.2, equations (19) and (20)),
// answered exactly for the doubles as they are stored: a filter in plain doubles,
// inline, and when its error bound cannot decide, exact arithmetic in geometry/exact.
// Bounds are proved in docs/predicates.md. Knows nothing of blocks, forces or time.
//
// Throughout, p1 -> p2 is an edge of a clockwise block, e = p2 - p1, L = |e|, the
// outward normal is on the left of e, and d is the overlap of a corner c with that
// edge: positive behind the edge, where the block is. Coordinates must be finite and
// edges longer than zero. All predicates are unchanged when all coordinates are
// multiplied by a power of two or shifted, as long as the stored doubles change by
// exactly that.
#pragma once

#include "geometry/vec2.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

#ifdef __FAST_MATH__
#error "the error bounds of the contact predicates do not hold under -ffast-math"
#endif

namespace blocks::geometry {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "the error bounds need IEEE doubles without extra precision");

/// Slack of "between" and of the nearest edge, as a part of the edge's length
/// (docs/departures.md). The double nearest 1e-6, taken as an exact number.
inline constexpr double contact_slack = 1e-6;

/// The same predicates without the filter, for the cases it leaves open.
namespace exact {

[[gnu::cold, gnu::noinline]] int overlap_sign(const Vec2& c, const Vec2& p1,
                                              const Vec2& p2);
[[gnu::cold, gnu::noinline]] bool near_or_inside(const Vec2& c, const Vec2& p1,
                                                 const Vec2& p2);
[[gnu::cold, gnu::noinline]] bool between(const Vec2& c, const Vec2& p1,
                                          const Vec2& p2);
[[gnu::cold, gnu::noinline]] bool within_depth(const Vec2& c, const Vec2& centroid,
                                               const Vec2& p1, const Vec2& p2);
[[gnu::cold, gnu::noinline]] bool faces_edge(const Vec2& c, const Vec2& neighbour,
                                             const Vec2& p1, const Vec2& p2);
[[gnu::cold, gnu::noinline]] int compare_depth(const Vec2& c, const Vec2& p1,
                                               const Vec2& p2, const Vec2& q1,
                                               const Vec2& q2);

/// How often the calling thread left the filters undecided.
unsigned long long calls();

/// How many of these needed multiple-precision numbers; the rest were settled by exact
/// sums of a few doubles.
unsigned long long multiprecision_calls();

}  // namespace exact

namespace filter {

// u = 2^-53 is the unit round-off. The bounds are multiples of u times the sum of the
// magnitudes of all terms; overflow makes that sum infinite (or NaN), and then no
// filter accepts. `underflow` exceeds whatever products of doubles lose below 2^-1022.
inline constexpr double u4 = 0x1p-51;
inline constexpr double u8 = 0x1p-50;
inline constexpr double u16 = 0x1p-49;
inline constexpr double underflow = 0x1p-1000;

inline constexpr double sin10_squared = 0.030153689607045807973;  // sin^2(10 degrees)

/// -1, 0 or +1.
inline int sign(double x) { return int{x > 0} - int{x < 0}; }

/// (c - o) x (p2 - p1) as two products whose difference it is.
struct Cross {
  double plus;
  double minus;

  double value() const { return plus - minus; }
  double magnitude() const { return std::abs(plus) + std::abs(minus); }
};

inline Cross cross(const Vec2& c, const Vec2& o, const Vec2& p1, const Vec2& p2) {
  return {(c.x() - o.x()) * (p2.y() - p1.y()), (c.y() - o.y()) * (p2.x() - p1.x())};
}

}  // namespace filter

/// Sign of the overlap d, that is of 2A = (xc-x1)(y2-y1) - (yc-y1)(x2-x1), equation
/// (19) on differences: +1 penetrated, 0 exactly on the edge's line, -1 outside.
/// Swapping p1 and p2 changes the sign; c = p1 and c = p2 give 0; any cyclic change of
/// (c, p1, p2) gives the same sign.
inline int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const filter::Cross a = filter::cross(c, p1, p1, p2);
  const double area = a.value();
  if (std::abs(area) > filter::u4 * a.magnitude() + filter::underflow) [[likely]]
    return filter::sign(area);
  return exact::overlap_sign(c, p1, p2);
}

/// 2A >= -eps L^2, that is d >= -eps L: true on the limit itself. True whenever
/// overlap_sign >= 0; of p1 -> p2 and p2 -> p1 at least one is true.
inline bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const double ex = p2.x() - p1.x();
  const double ey = p2.y() - p1.y();
  const filter::Cross a = filter::cross(c, p1, p1, p2);
  const double slack = contact_slack * (ex * ex + ey * ey);
  const double sum = a.value() + slack;
  if (std::abs(sum) > filter::u8 * (a.magnitude() + slack) + filter::underflow)
      [[likely]]
    return sum > 0;
  return exact::near_or_inside(c, p1, p2);
}

/// -eps L^2 <= (c - p1).e <= (1 + eps) L^2: true on both limits. Unchanged when p1 and
/// p2 are swapped.
inline bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const double ex = p2.x() - p1.x();
  const double ey = p2.y() - p1.y();
  const double along_x = (c.x() - p1.x()) * ex;
  const double along_y = (c.y() - p1.y()) * ey;
  const double along = along_x + along_y;
  const double length2 = ex * ex + ey * ey;
  const double slack = contact_slack * length2;
  const double after_start = along + slack;
  const double before_end = (length2 - along) + slack;
  const double bound = filter::u8 * (std::abs(along_x) + std::abs(along_y) + length2) +
                       filter::underflow;
  const bool sure = (std::abs(after_start) > bound) & (std::abs(before_end) > bound);
  if (sure) [[likely]]
    return (after_start > 0) & (before_end > 0);
  return exact::between(c, p1, p2);
}

/// The overlap of c is at most the distance of the edge from its block's centroid:
/// 2A(c) <= 2A(centroid) (rule "not deeper than the centroid", docs/departures.md).
/// True when equally deep; of (c, g) and (g, c) at least one is true.
inline bool within_depth(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                         const Vec2& p2) {
  const filter::Cross a = filter::cross(c, centroid, p1, p2);
  const double deeper = a.value();
  if (std::abs(deeper) > filter::u4 * a.magnitude() + filter::underflow) [[likely]]
    return deeper < 0;
  return exact::within_depth(c, centroid, p1, p2);
}

/// near_or_inside, between and within_depth together, for the loop: one evaluation of
/// their common terms settles nearly every potential contact. Law: equal to
/// near_or_inside && between && within_depth.
inline bool in_reach_of_edge(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                             const Vec2& p2) {
  const double ex = p2.x() - p1.x();
  const double ey = p2.y() - p1.y();
  const double along_x = (c.x() - p1.x()) * ex;
  const double along_y = (c.y() - p1.y()) * ey;
  const double along = along_x + along_y;
  const double length2 = ex * ex + ey * ey;
  const double slack = contact_slack * length2;
  const filter::Cross a = filter::cross(c, p1, p1, p2);
  const filter::Cross g = filter::cross(c, centroid, p1, p2);
  // One bound above those of the three single filters.
  const double bound = filter::u16 * (a.magnitude() + g.magnitude() +
                                      std::abs(along_x) + std::abs(along_y) + length2) +
                       filter::underflow;
  const double least = std::min(std::min(a.value() + slack, -g.value()),
                                std::min(along + slack, (length2 - along) + slack));
  if (std::abs(least) > bound) [[likely]]
    return least > 0;
  return near_or_inside(c, p1, p2) && between(c, p1, p2) &&
         within_depth(c, centroid, p1, p2);
}

/// Equation (20) for one tangent t = neighbour - c of the corner: t.n >= sin(-10
/// deg)|t|. The limit itself is never met: sin(10 deg) is the root of an irreducible
/// cubic. neighbour = c counts as true. Unchanged when t or e is scaled, or when both
/// are swapped and one of them reversed.
inline bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                       const Vec2& p2) {
  const double ex = p2.x() - p1.x();
  const double ey = p2.y() - p1.y();
  const double tx = neighbour.x() - c.x();
  const double ty = neighbour.y() - c.y();
  const double sine = ex * ty - ey * tx;  // |e| |t| times t.n
  const double e2 = ex * ex + ey * ey;
  const double t2 = tx * tx + ty * ty;
  const double q = e2 * t2;
  // x|x| grows with x, so squares with their sign compare as the sines do: no root.
  const double excess = sine * std::abs(sine) + filter::sin10_squared * q;
  const bool sure =
      (std::abs(excess) > filter::u16 * q) & (e2 > 0x1p-480) & (t2 > 0x1p-480);
  if (sure) [[likely]]
    return excess > 0;
  return exact::faces_edge(c, neighbour, p1, p2);
}

/// Sign of (overlap of c with p1 -> p2) - (overlap of c with q1 -> q2), both with their
/// sign: -1 when edge p is the nearer one (docs/departures.md, nearest edge), 0 when
/// exactly equal. Swapping the edges changes the sign; a common corner of two edges is
/// equally deep, 0, in both.
inline int compare_depth(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& q1,
                         const Vec2& q2) {
  const filter::Cross a = filter::cross(c, p1, p1, p2);
  const filter::Cross b = filter::cross(c, q1, q1, q2);
  const double p_length2 = (p2 - p1).squaredNorm();
  const double q_length2 = (q2 - q1).squaredNorm();
  const double p_length = std::sqrt(p_length2);
  const double q_length = std::sqrt(q_length2);
  const double difference = a.value() * q_length - b.value() * p_length;
  const double bound = filter::u16 * ((a.magnitude() + filter::underflow) * q_length +
                                      (b.magnitude() + filter::underflow) * p_length) +
                       filter::underflow;
  const bool sure =
      (std::abs(difference) > bound) & (p_length2 > 0x1p-900) & (q_length2 > 0x1p-900);
  if (sure) [[likely]]
    return filter::sign(difference);
  return exact::compare_depth(c, p1, p2, q1, q2);
}

}  // namespace blocks::geometry
