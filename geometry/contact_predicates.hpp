// Predicates of contact detection (report 3.3, equations (19) and (20)). Each answer
// is exact for the doubles as they are stored. An inline filter in plain doubles
// answers first. If its error bound does not decide, exact arithmetic in geometry/exact
// does. The bounds are proved in docs/predicates.md. Independent of blocks, forces and
// time.
//
// Throughout, p1 -> p2 is an edge of a clockwise block, e = p2 - p1 and L = |e|. The
// outward normal is on the left of e. d is the overlap of a corner c with that edge; it
// is positive behind the edge, where the block is. eps is contact_slack. Coordinates
// must be finite and edges longer than zero. Scaling all coordinates by a power of two,
// or shifting them, changes no predicate if the stored doubles change by exactly that.
#pragma once

#include "geometry/contact_constants.hpp"
#include "geometry/vec2.hpp"

#include <cfloat>
#include <cmath>
#include <limits>

#ifdef __FAST_MATH__
#error "the error bounds of the contact predicates do not hold under -ffast-math"
#endif

namespace blocks::geometry {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "the error bounds need IEEE doubles without extra precision");

/// The same predicates without the filter, for the cases that the filter leaves open.
namespace exact {

[[gnu::cold, gnu::noinline]] int overlap_sign(const Vec2& c, const Vec2& p1,
                                              const Vec2& p2);
[[gnu::cold, gnu::noinline]] bool near_or_inside(const Vec2& c, const Vec2& p1,
                                                 const Vec2& p2);
[[gnu::cold, gnu::noinline]] bool between(const Vec2& c, const Vec2& p1,
                                          const Vec2& p2);
[[gnu::cold, gnu::noinline]] bool faces_edge(const Vec2& c, const Vec2& neighbour,
                                             const Vec2& p1, const Vec2& p2);
[[gnu::cold, gnu::noinline]] bool well_between(const Vec2& c, const Vec2& p1,
                                               const Vec2& p2);
[[gnu::cold, gnu::noinline]] int turn_sign(const Vec2& p1, const Vec2& p2,
                                           const Vec2& q1, const Vec2& q2);
[[gnu::cold, gnu::noinline]] bool edges_face(const Vec2& p1, const Vec2& p2,
                                             const Vec2& q1, const Vec2& q2);
[[gnu::cold, gnu::noinline]] int compare_depths(const Vec2& c, const Vec2& p1,
                                                const Vec2& p2, const Vec2& d,
                                                const Vec2& q1, const Vec2& q2);
[[gnu::cold, gnu::noinline]] int compare_slopes(const Vec2& p1, const Vec2& p2,
                                                const Vec2& q1, const Vec2& q2,
                                                const Vec2& r1, const Vec2& r2);

/// Returns how many predicates of the calling thread the filters left undecided.
unsigned long long calls();

/// Returns how many of these needed multiple-precision numbers. Exact sums of a few
/// doubles decided the others.
unsigned long long multiprecision_calls();

}  // namespace exact

namespace filter {

// u = 2^-53 is the unit round-off. Each bound is a multiple of u times the sum of the
// magnitudes of all terms. If that sum overflows, it is infinite or NaN, and no filter
// accepts. `underflow` is more than products of doubles can lose below 2^-1022.
inline constexpr double u4 = 0x1p-51;
inline constexpr double u8 = 0x1p-50;
inline constexpr double u16 = 0x1p-49;
inline constexpr double u24 = 0x1.8p-49;
inline constexpr double underflow = 0x1p-1000;

/// Returns -1, 0 or +1.
inline int sign(double x) { return int{x > 0} - int{x < 0}; }

/// A value and the bound of its error. The sign of the value is certain if its
/// magnitude exceeds the bound.
struct Estimate {
  double value;
  double bound;

  bool positive() const { return value > bound; }
  bool negative() const { return value < -bound; }
};

// The smaller of a and b. A NaN may be dropped, but then the bound is NaN or infinite
// as well.
inline double min(double a, double b) { return b < a ? b : a; }

inline double unless(bool safe, double bound) {
  return safe ? bound : std::numeric_limits<double>::infinity();
}

/// (c - o) x (p2 - p1), stored as the two products whose difference it is.
struct Cross {
  double plus;
  double minus;

  double value() const { return plus - minus; }
  double magnitude() const { return std::abs(plus) + std::abs(minus); }
};

/// (c - p1).(p2 - p1), stored as the two products whose sum it is.
struct Dot {
  double x;
  double y;

  double value() const { return x + y; }
  double magnitude() const { return std::abs(x) + std::abs(y); }
};

inline Cross cross(const Vec2& c, const Vec2& o, const Vec2& p1, const Vec2& p2) {
  return {(c.x() - o.x()) * (p2.y() - p1.y()), (c.y() - o.y()) * (p2.x() - p1.x())};
}

inline Dot dot(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  return {(c.x() - p1.x()) * (p2.x() - p1.x()), (c.y() - p1.y()) * (p2.y() - p1.y())};
}

inline double squared_length(const Vec2& p1, const Vec2& p2) {
  const double ex = p2.x() - p1.x();
  const double ey = p2.y() - p1.y();
  return ex * ex + ey * ey;
}

inline Estimate overlap(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const Cross a = cross(c, p1, p1, p2);
  return {a.value(), u4 * a.magnitude() + underflow};
}

inline Estimate near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const Cross a = cross(c, p1, p1, p2);
  const double slack = contact_slack * squared_length(p1, p2);
  return {a.value() + slack, u8 * (a.magnitude() + slack) + underflow};
}

/// part: how far c may be beyond either end, as a fraction of the edge's length. A
/// negative value means that c must be that far inside both ends.
inline Estimate between(const Vec2& c, const Vec2& p1, const Vec2& p2,
                        double part = contact_slack) {
  const Dot along = dot(c, p1, p2);
  const double length2 = squared_length(p1, p2);
  const double slack = part * length2;
  return {min(along.value() + slack, (length2 - along.value()) + slack),
          u8 * (along.magnitude() + length2) + underflow};
}

/// x|x| increases with x, so signed squares compare as the sines do, and no square root
/// is needed.
inline Estimate faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                           const Vec2& p2) {
  const Cross a = cross(neighbour, c, p1, p2);
  const double sine = a.minus - a.plus;  // |e| |t| times t.n
  const double e2 = squared_length(p1, p2);
  const double t2 = squared_length(c, neighbour);
  const double q = e2 * t2;
  return {sine * std::abs(sine) + facing_sine_squared * q,
          unless(min(e2, t2) > 0x1p-480, u16 * q)};
}

inline Estimate turn(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
  const Cross a = cross(p2, p1, q1, q2);
  return {a.value(), u4 * a.magnitude() + underflow};
}

/// Let D be the dot product of the two edges and Q the product of their squared
/// lengths. The value is positive where D <= -cos(10 degrees) sqrt(Q).
inline Estimate edges_face(const Vec2& p1, const Vec2& p2, const Vec2& q1,
                           const Vec2& q2) {
  const double ex = p2.x() - p1.x(), ey = p2.y() - p1.y();
  const double fx = q2.x() - q1.x(), fy = q2.y() - q1.y();
  const double d = ex * fx + ey * fy;
  const double e2 = ex * ex + ey * ey, f2 = fx * fx + fy * fy;
  const double q = e2 * f2;
  return {-d * std::abs(d) - facing_cosine_squared * q,
          unless(min(e2, f2) > 0x1p-480, u24 * q)};
}

/// Returns 1 / |p2 - p1| for `depth`, or infinity if products of such lengths leave the
/// range of doubles.
inline double per_length(const Vec2& p1, const Vec2& p2) {
  const double length2 = squared_length(p1, p2);
  return length2 > 0x1p-900 && length2 < 0x1p900
             ? 1.0 / std::sqrt(length2)
             : std::numeric_limits<double>::infinity();
}

/// The overlap d = 2A / L, [L].
inline Estimate depth(const Vec2& c, const Vec2& p1, const Vec2& p2,
                      double per_length) {
  const Cross a = cross(c, p1, p1, p2);
  return {a.value() * per_length,
          (u16 * a.magnitude() + underflow) * per_length + underflow};
}

/// Positive where the angle between p and q has a larger sine than the angle between p
/// and r.
inline Estimate slope_difference(const Vec2& p1, const Vec2& p2, const Vec2& q1,
                                 const Vec2& q2, const Vec2& r1, const Vec2& r2) {
  const Cross a = cross(p2, p1, q1, q2);
  const Cross b = cross(p2, p1, r1, r2);
  const double q_length2 = squared_length(q1, q2);
  const double r_length2 = squared_length(r1, r2);
  const double q_length = std::sqrt(q_length2), r_length = std::sqrt(r_length2);
  return {std::abs(a.value()) * r_length - std::abs(b.value()) * q_length,
          unless(min(q_length2, r_length2) > 0x1p-900,
                 u16 * ((a.magnitude() + underflow) * r_length +
                        (b.magnitude() + underflow) * q_length) +
                     underflow)};
}

inline Estimate depth_difference(const Vec2& c, const Vec2& p1, const Vec2& p2,
                                 const Vec2& d, const Vec2& q1, const Vec2& q2) {
  const Cross a = cross(c, p1, p1, p2);
  const Cross b = cross(d, q1, q1, q2);
  const double p_length2 = squared_length(p1, p2);
  const double q_length2 = squared_length(q1, q2);
  const double p_length = std::sqrt(p_length2);
  const double q_length = std::sqrt(q_length2);
  return {a.value() * q_length - b.value() * p_length,
          unless(min(p_length2, q_length2) > 0x1p-900,
                 u16 * ((a.magnitude() + underflow) * q_length +
                        (b.magnitude() + underflow) * p_length) +
                     underflow)};
}

}  // namespace filter

/// Sign of the overlap d: +1 behind the edge, 0 exactly on its line, -1 outside. It is
/// the sign of 2A = (xc-x1)(y2-y1) - (yc-y1)(x2-x1), equation (19) written with
/// differences. Swapping p1 and p2 changes the sign. c = p1 and c = p2 give 0. Any
/// cyclic change of (c, p1, p2) gives the same sign.
inline int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const filter::Estimate d = filter::overlap(c, p1, p2);
  if (d.positive())
    return 1;
  if (d.negative())
    return -1;
  return exact::overlap_sign(c, p1, p2);
}

/// Tests 2A >= -eps L^2, that is d >= -eps L; true on the limit itself. True whenever
/// overlap_sign >= 0. True for at least one of p1 -> p2 and p2 -> p1.
inline bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const filter::Estimate d = filter::near_or_inside(c, p1, p2);
  if (d.positive()) [[likely]]
    return true;
  if (d.negative())
    return false;
  return exact::near_or_inside(c, p1, p2);
}

/// Tests -eps L^2 <= (c - p1).e <= (1 + eps) L^2; true on both limits. Unchanged when
/// p1 and p2 are swapped.
inline bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const filter::Estimate d = filter::between(c, p1, p2);
  if (d.positive()) [[likely]]
    return true;
  if (d.negative())
    return false;
  return exact::between(c, p1, p2);
}

/// Tests eps L^2 <= (c - p1).e <= (1 - eps) L^2: c is between the ends, and at least
/// the slack away from both. Implies between. Unchanged when p1 and p2 are swapped.
inline bool well_between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  const filter::Estimate d = filter::between(c, p1, p2, -contact_slack);
  if (d.positive()) [[likely]]
    return true;
  if (d.negative())
    return false;
  return exact::well_between(c, p1, p2);
}

/// Equation (20) for one tangent t = neighbour - c of the corner: t.n >=
/// sin(-10 deg) |t|. Equality never occurs, because sin(10 deg) is a root of an
/// irreducible cubic. neighbour = c counts as true. Unchanged when t or e is scaled, or
/// when both are swapped and one of them is reversed.
inline bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                       const Vec2& p2) {
  const filter::Estimate d = filter::faces_edge(c, neighbour, p1, p2);
  if (d.positive()) [[likely]]
    return true;
  if (d.negative())
    return false;
  return exact::faces_edge(c, neighbour, p1, p2);
}

/// Sign of (p2 - p1) x (q2 - q1): +1 when edge q is rotated anticlockwise from edge p,
/// 0 when parallel or antiparallel. Swapping the two edges changes the sign.
inline int turn_sign(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
  const filter::Estimate d = filter::turn(p1, p2, q1, q2);
  if (d.positive())
    return 1;
  if (d.negative())
    return -1;
  return exact::turn_sign(p1, p2, q1, q2);
}

/// Equation (20) for two edges. Tests whether they are antiparallel within ten degrees:
/// (p2 - p1).(q2 - q1) <= -cos(10 deg) |p2 - p1| |q2 - q1|. Equality never occurs, as
/// in faces_edge. Unchanged when the edges are swapped.
inline bool edges_face(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
  const filter::Estimate d = filter::edges_face(p1, p2, q1, q2);
  if (d.positive())
    return true;
  if (d.negative())
    return false;
  return exact::edges_face(p1, p2, q1, q2);
}

/// Sign of (overlap of c with p1 -> p2) - (overlap of d with q1 -> q2): -1 when the
/// first is smaller, 0 when they are exactly equal. Swapping (c, p) with (d, q) changes
/// the sign.
inline int compare_depths(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& d,
                          const Vec2& q1, const Vec2& q2) {
  const filter::Estimate difference = filter::depth_difference(c, p1, p2, d, q1, q2);
  if (difference.positive())
    return 1;
  if (difference.negative())
    return -1;
  return exact::compare_depths(c, p1, p2, d, q1, q2);
}

/// Sign of |sin(angle between p and q)| - |sin(angle between p and r)|: -1 when edge q
/// is more nearly parallel to edge p than edge r is, 0 when exactly equal.
inline int compare_slopes(const Vec2& p1, const Vec2& p2, const Vec2& q1,
                          const Vec2& q2, const Vec2& r1, const Vec2& r2) {
  const filter::Estimate d = filter::slope_difference(p1, p2, q1, q2, r1, r2);
  if (d.positive())
    return 1;
  if (d.negative())
    return -1;
  return exact::compare_slopes(p1, p2, q1, q2, r1, r2);
}

}  // namespace blocks::geometry
