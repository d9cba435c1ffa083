// PRIVATE to geometry/: fractions that are not reduced. The greatest common divisors of
// reduced rationals cost more than all the rest of cutting a layer.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "geometry/exact/kernels.hpp"

namespace blocks::geometry::exact {

using Integer = CGAL::Gmpz;

/// num / den, den > 0, common divisors allowed.
struct Fraction {
  Integer num = 0;
  Integer den = 1;

  Fraction() = default;
  Fraction(const Integer& n, const Integer& d)
      : num(d < 0 ? Integer(-n) : n), den(d < 0 ? Integer(-d) : d) {}
  explicit Fraction(const Rational& r) : num(r.numerator()), den(r.denominator()) {}
  Rational reduced() const { return {num, den}; }
};

/// Decided on doubles where these are sure: each quotient is off by less than four
/// units of round-off (two whole numbers cut to 53 bits, one division).
inline bool operator<(const Fraction& a, const Fraction& b) {
  const double x = mpz_get_d(a.num.mpz()) / mpz_get_d(a.den.mpz());
  const double y = mpz_get_d(b.num.mpz()) / mpz_get_d(b.den.mpz());
  const double larger = std::max(std::abs(x), std::abs(y));
  if (std::abs(x - y) > 0x1p-49 * larger && 1e-290 < larger && larger < 1e290)
    return x < y;
  return a.num * b.den < b.num * a.den;
}

/// The least common multiple of the denominators.
Integer common_denominator(std::initializer_list<Rational> values);

/// value * scale, where that is whole.
inline Integer times(const Rational& value, const Integer& scale) {
  return value.numerator() * (scale / value.denominator());
}

}  // namespace blocks::geometry::exact
