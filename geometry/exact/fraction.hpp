// PRIVATE to geometry/: fractions that are not reduced. Reducing rationals by greatest
// common divisors would cost more than all other work of cutting a layer.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "geometry/exact/kernels.hpp"

namespace blocks::geometry::exact {

using Integer = CGAL::Gmpz;

/// num / den with den > 0; common divisors are allowed.
struct Fraction {
  Integer num = 0;
  Integer den = 1;

  Fraction() = default;
  Fraction(const Integer& n, const Integer& d)
      : num(d < 0 ? Integer(-n) : n), den(d < 0 ? Integer(-d) : d) {}
  explicit Fraction(const Rational& r) : num(r.numerator()), den(r.denominator()) {}
  Rational reduced() const { return {num, den}; }
};

/// Compares doubles first, if their difference is certain. Each quotient has an error
/// below four units of round-off: two integers truncated to 53 bits, and one division.
inline bool operator<(const Fraction& a, const Fraction& b) {
  const double x = mpz_get_d(a.num.mpz()) / mpz_get_d(a.den.mpz());
  const double y = mpz_get_d(b.num.mpz()) / mpz_get_d(b.den.mpz());
  const double larger = std::max(std::abs(x), std::abs(y));
  if (std::abs(x - y) > 0x1p-49 * larger && 1e-290 < larger && larger < 1e290)
    return x < y;
  return a.num * b.den < b.num * a.den;
}

/// Returns the least common multiple of the denominators.
Integer common_denominator(std::initializer_list<Rational> values);

/// Returns value * scale, which must be an integer.
inline Integer times(const Rational& value, const Integer& scale) {
  return value.numerator() * (scale / value.denominator());
}

}  // namespace blocks::geometry::exact
