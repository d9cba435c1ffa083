// PRIVATE to geometry/: the part of a side that lies in a convex polygon, exactly or as
// bounds. The number type is a quotient, a rational or an interval of doubles.
#pragma once

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Quotient.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "geometry/exact/kernels.hpp"
#include "geometry/outline.hpp"

namespace blocks::geometry::sides {

using exact::Rational;
/// Quotients of exact sums and products of doubles. They are never reduced, and so a
/// few times as fast as rationals for short expressions.
using Exact = CGAL::Quotient<CGAL::Mpzf>;
/// Rounding must be upwards while these are used (Interval::Protector).
using Interval = CGAL::Interval_nt<false>;

template <class Number> struct Vector {
  Number x, y;
  Vector(const Vec2& from, const Vec2& to)
      : x(Number(to.x()) - Number(from.x())), y(Number(to.y()) - Number(from.y())) {}
};
template <class Number> Number cross(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class Number> Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y;
}

/// Thrown if a bound of an interval is NaN.
struct Overflow {};

inline Exact min_of(const Exact& a, const Exact& b) { return b < a ? b : a; }
inline Exact max_of(const Exact& a, const Exact& b) { return a < b ? b : a; }
inline Rational min_of(const Rational& a, const Rational& b) { return b < a ? b : a; }
inline Rational max_of(const Rational& a, const Rational& b) { return a < b ? b : a; }

/// Throws if a bound is NaN, as after an overflow; std::min and std::max would drop it.
inline void require_bounds(const Interval& a) {
  if (std::isnan(a.inf()) || std::isnan(a.sup()))
    throw Overflow();
}
inline Interval min_of(const Interval& a, const Interval& b) {
  require_bounds(a), require_bounds(b);
  return {std::min(a.inf(), b.inf()), std::min(a.sup(), b.sup())};
}
inline Interval max_of(const Interval& a, const Interval& b) {
  require_bounds(a), require_bounds(b);
  return {std::max(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}

/// Returns the interval of all numbers between a and b.
inline Interval range(const Interval& a, const Interval& b) {
  require_bounds(a), require_bounds(b);
  return {a.inf(), b.sup()};
}

/// A part of a side, in [0, 1] along it.
template <class Number> struct Part {
  Number from, to;
  Number length() const { return to - from; }
  Part common(const Part& other) const {
    return {max_of(from, other.from), min_of(to, other.to)};
  }
  bool is_empty() const { return CGAL::certainly(to <= from); }
};

inline const Vec2& start_of(Outline polygon, int side) {
  return polygon[static_cast<std::size_t>(side)];
}
inline const Vec2& end_of(Outline polygon, int side) {
  const std::size_t next = static_cast<std::size_t>(side) + 1;
  return polygon[next < polygon.size() ? next : 0];
}

/// Returns the part of a side behind a line, from twice the areas below the line at its
/// two ends.
template <class Number>
Part<Number> part_behind(const Number& first, const Number& last) {
  const Number zero(0), one(1);
  if (CGAL::certainly(first >= 0) && CGAL::certainly(last >= 0))
    return {zero, one};
  if (CGAL::certainly(first <= 0) && CGAL::certainly(last <= 0))
    return {one, zero};
  if (CGAL::certainly(first > 0) && CGAL::certainly(last < 0))
    return {zero, first / (first - last)};
  if (CGAL::certainly(first < 0) && CGAL::certainly(last > 0))
    return {first / (first - last), one};
  if constexpr (std::is_same_v<Number, Interval>) {
    if (CGAL::certainly(first > 0))  // the side may or may not leave before its end
      return {zero, last.inf() < 0 ? range(first / (first - last.inf()), one) : one};
    if (CGAL::certainly(last > 0))
      return {first.inf() < 0 ? range(zero, first.inf() / (first.inf() - last)) : zero,
              one};
    return {range(zero, one), range(zero, one)};
  }
  return {one, zero};
}

/// Returns the part of a side that lies in a convex polygon, as precisely as the number
/// type allows.
template <class Number> Part<Number> part_in(Outline polygon, int side, Outline other) {
  Part<Number> part{Number(0), Number(1)};
  const Vec2 &start = start_of(polygon, side), &stop = end_of(polygon, side);
  for (int k = 0; k < static_cast<int>(other.size()) && !part.is_empty(); ++k) {
    const Vec2& corner = start_of(other, k);
    const Vector<Number> line(corner, end_of(other, k));
    part = part.common(part_behind(cross(Vector<Number>(corner, start), line),
                                   cross(Vector<Number>(corner, stop), line)));
  }
  return part;
}

}  // namespace blocks::geometry::sides
