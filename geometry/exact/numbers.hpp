// PRIVATE to geometry/: into the rationals and out of them again. CGAL::to_double is
// not correctly rounded, so what leaves is rounded here, from the whole numbers.
#pragma once

#include "geometry/decimal.hpp"
#include "geometry/exact/fraction.hpp"

namespace blocks::geometry::exact {

/// digits * 10^exponent, without error.
Rational rational(const Decimal& decimal);
Point rational(const DecimalPoint& point);

/// The nearest double, ties to even. Laws: nearest(-r) = -nearest(r); a double comes
/// back unchanged; infinite beyond the range of a double.
double nearest(const Rational& value);
Vec2 nearest(const Point& point);

/// The largest double not above the value (side < 0), the smallest not below it
/// (side > 0), or the nearest (side = 0).
double rounded_towards(const Rational& value, int side);
double rounded_towards(const Fraction& value, int side);

/// (from + length * s) / unit, rounded the same way; unit > 0.
double rounded_place(const Integer& from, const Integer& length, const Integer& unit,
                     const Fraction& s, int side);

/// The tangent of an angle in degrees, |angle| <= 89: the double nearest to it, the
/// same on every machine (exactly 0 at 0 and 1 at 45 degrees).
double tangent_of_degrees(const Rational& degrees);

}  // namespace blocks::geometry::exact
