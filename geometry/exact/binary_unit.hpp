// PRIVATE to geometry/: doubles as whole multiples of one power of two. Sums and
// products of such integers need no common divisors.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/exact/fraction.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry::exact {

/// The power of two that measures all doubles it has seen in whole numbers.
class BinaryUnit {
 public:
  /// Makes the unit small enough for a finite double.
  void see(double x) {
    if (x != 0.0)
      exponent_ = std::min(exponent_, parts(x).exponent);
  }
  void see(const Vec2& v) {
    see(v.x());
    see(v.y());
  }
  /// Returns x in this unit; see(x) or see(-x) was called before.
  Integer operator()(double x) const {
    Integer whole;
    set(whole, x);
    return whole;
  }
  /// Likewise, but keeps the memory of `whole`, which must not be shared.
  void set(Integer& whole, double x) const {
    const Parts p = parts(x);
    mpz_set_si(whole.mpz(), static_cast<long>(p.mantissa));
    if (p.mantissa != 0)
      mpz_mul_2exp(whole.mpz(), whole.mpz(),
                   static_cast<mp_bitcnt_t>(p.exponent - exponent_));
  }
  /// Returns value * unit^power as a fraction.
  Fraction times_unit(const Integer& value, int power) const {
    const long shift = exponent_ == none ? 0 : static_cast<long>(exponent_) * power;
    Fraction result(value, 1);
    Integer& part = shift < 0 ? result.den : result.num;
    Integer scaled;  // the memory of `part` may be shared
    mpz_mul_2exp(scaled.mpz(), part.mpz(), static_cast<mp_bitcnt_t>(std::abs(shift)));
    part = scaled;
    return result;
  }

 private:
  static constexpr int none = std::numeric_limits<int>::max();
  struct Parts {
    std::int64_t mantissa;  ///< odd, or 0
    int exponent;
  };
  static Parts parts(double x) {
    int exponent = 0;
    constexpr int digits = std::numeric_limits<double>::digits;
    const auto whole =
        static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), digits));
    if (whole == 0)
      return {0, 0};
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(whole));
    return {whole >> zeros, exponent - digits + zeros};
  }

  int exponent_ = none;
};

}  // namespace blocks::geometry::exact
