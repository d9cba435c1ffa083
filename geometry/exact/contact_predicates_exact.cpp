// The exact part of geometry/contact_predicates.hpp. Exact sums of a few doubles come
// first; they decide for corners that lie on an edge. CGAL's multiple-precision numbers
// decide the rest.
#include "geometry/contact_predicates.hpp"

#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>
#ifndef CGAL_HAS_MPZF
#include <CGAL/Exact_rational.h>
#endif

#include <cmath>

namespace blocks::geometry::exact {

namespace {

// The predicates need only sums and products, so a ring is enough.
#ifdef CGAL_HAS_MPZF
using Number = CGAL::Mpzf;
#else
using Number = CGAL::Exact_rational;
#endif
using RingKernel = CGAL::Simple_cartesian<Number>;

thread_local unsigned long long undecided_by_filter = 0;
thread_local unsigned long long undecided_by_doubles = 0;

constexpr int unknown = 2;

/// a - b as an exact sum of two doubles (Knuth): value = fl(a - b), and tail is the
/// rest. On overflow the tail is NaN, so no test of it succeeds.
struct Difference {
  double value;
  double tail;

  Difference(double a, double b) : value(a - b) {
    const double b_part = a - value;
    const double a_part = value + b_part;
    tail = (a - a_part) + (b_part - b);
  }
};

/// Returns the sign of (c - o) x (p2 - p1) by exact sums of doubles, or `unknown`.
int cross_sign_in_doubles(const Vec2& c, const Vec2& o, const Vec2& p1,
                          const Vec2& p2) {
  const Difference dx(c.x(), o.x());
  const Difference dy(c.y(), o.y());
  const Difference ex(p2.x(), p1.x());
  const Difference ey(p2.y(), p1.y());
  // A difference is zero only if its two numbers are equal, so these zeros are exact.
  const bool plus_zero = dx.value == 0 || ey.value == 0;
  const bool minus_zero = dy.value == 0 || ex.value == 0;
  if (plus_zero && minus_zero)
    return 0;

  const double plus = dx.value * ey.value;
  const double minus = dy.value * ex.value;
  // Within these limits the tails of the products, and products with tails, do not
  // underflow.
  constexpr double small = 0x1p-800;
  constexpr double large = 0x1p1000;
  const bool plus_safe =
      plus_zero || (std::abs(plus) > small && std::abs(plus) < large);
  const bool minus_safe =
      minus_zero || (std::abs(minus) > small && std::abs(minus) < large);
  if (!plus_safe || !minus_safe)
    return unknown;
  const double plus_tail = std::fma(dx.value, ey.value, -plus);
  const double minus_tail = std::fma(dy.value, ex.value, -minus);

  if (dx.tail == 0 && dy.tail == 0 && ex.tail == 0 && ey.tail == 0) {
    // Rounding is monotone, so the tails decide only if the heads are equal.
    if (plus != minus)
      return plus > minus ? 1 : -1;
    return filter::sign(plus_tail - minus_tail);
  }
  // The sum is taken to second order. What is left out is at most a few u^2 of the
  // magnitude.
  const Difference head(plus, minus);
  const double rest =
      (plus_tail - minus_tail) + ((dx.value * ey.tail + dx.tail * ey.value) -
                                  (dy.value * ex.tail + dy.tail * ex.value));
  const double sum = head.value + (head.tail + rest);
  const bool sure = std::isfinite(sum) &&
                    std::abs(sum) > 0x1p-98 * (std::abs(plus) + std::abs(minus));
  if (sure)
    return filter::sign(sum);
  return unknown;
}

struct Vector {
  Number x;
  Number y;

  Vector(const Vec2& from, const Vec2& to)
      : x(Number(to.x()) - Number(from.x())), y(Number(to.y()) - Number(from.y())) {}
};

Number cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }

int sign(const Number& a) { return static_cast<int>(CGAL::sign(a)); }

int cross_sign(const Vec2& c, const Vec2& o, const Vec2& p1, const Vec2& p2) {
  const int quick = cross_sign_in_doubles(c, o, p1, p2);
  if (quick != unknown)
    return quick;
  ++undecided_by_doubles;
  const auto vector = [](const Vec2& from, const Vec2& to) {
    return RingKernel::Vector_2(Number(to.x()) - Number(from.x()),
                                Number(to.y()) - Number(from.y()));
  };
  return static_cast<int>(RingKernel::Orientation_2()(vector(o, c), vector(p1, p2)));
}

/// Tests -part L^2 <= (c - p1).e <= (1 + part) L^2.
bool between_ends(const Vec2& c, const Vec2& p1, const Vec2& p2, double part) {
  ++undecided_by_filter;
  ++undecided_by_doubles;
  const Vector e(p1, p2);
  const Number along = dot(Vector(p1, c), e);
  const Number length2 = dot(e, e);
  const Number slack = Number(part) * length2;
  return sign(along + slack) >= 0 && sign(length2 + slack - along) >= 0;
}

/// Tests whether an angle is at most ten degrees or at least 170, if the square of its
/// sine is y = sine^2 / q. In [0, 1/4] the cubic 64y^3 - 96y^2 + 36y - 1 increases, and
/// sin^2(10 deg) is its only root.
bool at_most_ten_degrees(const Number& sine, const Number& q) {
  const Number a = sine * sine;
  if (sign(Number(4) * a - q) >= 0)
    return false;
  const Number a2 = a * a;
  const Number q2 = q * q;
  const Number cubic =
      Number(64) * a2 * a - Number(96) * a2 * q + Number(36) * a * q2 - q2 * q;
  return sign(cubic) <= 0;
}

}  // namespace

unsigned long long calls() { return undecided_by_filter; }
unsigned long long multiprecision_calls() { return undecided_by_doubles; }

int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  ++undecided_by_filter;
  return cross_sign(c, p1, p1, p2);
}

bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  ++undecided_by_filter;
  ++undecided_by_doubles;
  const Vector e(p1, p2);
  return sign(cross(Vector(p1, c), e) + Number(contact_slack) * dot(e, e)) >= 0;
}

bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  return between_ends(c, p1, p2, contact_slack);
}

bool well_between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  return between_ends(c, p1, p2, -contact_slack);
}

bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1, const Vec2& p2) {
  ++undecided_by_filter;
  ++undecided_by_doubles;
  const Vector e(p1, p2);
  const Vector t(c, neighbour);
  const Number sine = cross(e, t);
  return sign(sine) >= 0 || at_most_ten_degrees(sine, dot(e, e) * dot(t, t));
}

int turn_sign(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
  ++undecided_by_filter;
  return cross_sign(p2, p1, q1, q2);
}

bool edges_face(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2) {
  ++undecided_by_filter;
  ++undecided_by_doubles;
  const Vector p(p1, p2), q(q1, q2);
  return sign(dot(p, q)) < 0 && at_most_ten_degrees(cross(p, q), dot(p, p) * dot(q, q));
}

int compare_slopes(const Vec2& p1, const Vec2& p2, const Vec2& q1, const Vec2& q2,
                   const Vec2& r1, const Vec2& r2) {
  ++undecided_by_filter;
  ++undecided_by_doubles;
  const Vector p(p1, p2), q(q1, q2), r(r1, r2);
  const Number a = cross(p, q), b = cross(p, r);
  return sign(a * a * dot(r, r) - b * b * dot(q, q));
}

int compare_depths(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& d,
                   const Vec2& q1, const Vec2& q2) {
  ++undecided_by_filter;
  const int p_sign = cross_sign(c, p1, p1, p2);
  const int q_sign = cross_sign(d, q1, q1, q2);
  if (p_sign != q_sign)
    return p_sign > q_sign ? 1 : -1;
  if (p_sign == 0)
    return 0;
  ++undecided_by_doubles;
  // The signs are equal, so compare d^2 = (2A)^2 / L^2, cross-multiplied.
  const Vector p(p1, p2);
  const Vector q(q1, q2);
  const Number a = cross(Vector(p1, c), p);
  const Number b = cross(Vector(q1, d), q);
  return p_sign * sign(a * a * dot(q, q) - b * b * dot(p, p));
}

}  // namespace blocks::geometry::exact
