// PRIVATE to geometry/: fractions that are not reduced. The greatest common divisors of
// reduced rationals cost more than all the rest of cutting a layer.
#pragma once

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

inline bool operator<(const Fraction& a, const Fraction& b) {
  return a.num * b.den < b.num * a.den;
}

/// The least common multiple of the denominators.
Integer common_denominator(std::initializer_list<Rational> values);

/// value * scale, where that is whole.
inline Integer times(const Rational& value, const Integer& scale) {
  return value.numerator() * (scale / value.denominator());
}

}  // namespace blocks::geometry::exact
