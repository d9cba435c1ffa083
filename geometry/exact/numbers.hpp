// PRIVATE to geometry/: conversion from decimals to rationals and from rationals to
// doubles. CGAL::to_double is not correctly rounded, so the rounding is done here, from
// numerator and denominator.
#pragma once

#include "geometry/decimal.hpp"
#include "geometry/exact/fraction.hpp"

namespace blocks::geometry::exact {

/// Returns digits * 10^exponent exactly.
Rational rational(const Decimal& decimal);
Point rational(const DecimalPoint& point);

/// Returns the nearest double, ties to even. Guarantees: nearest(-r) = -nearest(r), and
/// a value that is a double is unchanged. The result is infinite beyond the range of
/// doubles.
double nearest(const Rational& value);
Vec2 nearest(const Point& point);

/// Returns the largest double not above the value (side < 0), the smallest double not
/// below it (side > 0), or the nearest double (side = 0).
double rounded_towards(const Rational& value, int side);
double rounded_towards(const Fraction& value, int side);

/// Returns num / den rounded as in rounded_towards; den > 0.
double rounded_quotient(mpz_srcptr num, mpz_srcptr den, int side);

/// Returns (from + length * s) / unit, rounded as in rounded_towards; unit > 0.
double rounded_place(const Integer& from, const Integer& length, const Integer& unit,
                     const Fraction& s, int side);

/// Returns the double nearest to the tangent of an angle in degrees, |angle| <= 89. The
/// result is the same on every machine, and exact at 0 and 45 degrees.
double tangent_of_degrees(const Rational& degrees);

/// Returns the doubles nearest to cosine and sine of an angle in degrees: a vector in
/// this direction. The result is the same on every machine, and exact for multiples of
/// 90 degrees.
Vec2 direction_of_degrees(const Rational& degrees);

/// Returns the double nearest to -ln(u), u in (0, 1). The result is the same on every
/// machine.
double negative_logarithm(double u);

}  // namespace blocks::geometry::exact
