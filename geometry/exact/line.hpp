// PRIVATE to geometry/: lines with integer coefficients. Their intersections need no
// common divisors, so they are faster than those of rationals.
#pragma once

#include "geometry/exact/numbers.hpp"

namespace blocks::geometry::exact {

/// The line a x + b y + c = 0; (-b, a) is its direction.
struct Line {
  Integer a, b, c;
  double run = 0.0, rise = 0.0;  ///< direction, scaled to about 1, to 51 bits or more

  Line(const Point& p, const Point& q);
};

/// Tests whether two lines are parallel.
bool parallel(const Line& s, const Line& t);
/// Tests whether the line contains the point.
bool on(const Line& line, const Point& p);

/// A point x / w, y / w with w > 0.
struct Place {
  Integer x, y, w;
  Point reduced() const { return {Rational(x, w), Rational(y, w)}; }
  Vec2 nearest() const {
    return {rounded_towards(Fraction(x, w), 0), rounded_towards(Fraction(y, w), 0)};
  }
};

/// Intersects two lines that are not parallel.
Place intersection(const Line& s, const Line& t);

}  // namespace blocks::geometry::exact
