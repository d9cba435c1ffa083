#include "geometry/exact/numbers.hpp"

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace blocks::geometry::exact {
namespace {

// Integers of this thread that keep their memory, so that rounding does not allocate.
struct Scratch {
  Scratch() { mpz_inits(scaled, quotient, remainder, nullptr); }
  ~Scratch() { mpz_clears(scaled, quotient, remainder, nullptr); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  mpz_t scaled, quotient, remainder;
};

constexpr int digits = std::numeric_limits<double>::digits;  // 53
constexpr long min_exponent = std::numeric_limits<double>::min_exponent - digits;

// MPFR caches pi and other numbers for each thread. This frees them when the thread
// ends.
struct MpfrCache {
  ~MpfrCache() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

// Sets an angle in radians. Its relative error is four roundings to `bits` bits. Clear
// the angle after use.
void init_radians(mpfr_t angle, mpfr_prec_t bits, const Rational& degrees) {
  static thread_local const MpfrCache cache;
  mpfr_t pi;
  mpfr_inits2(bits, angle, pi, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_q(angle, degrees.mpq(), MPFR_RNDN);
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_mul(angle, angle, pi, MPFR_RNDN);
  mpfr_div_ui(angle, angle, 180, MPFR_RNDN);
  mpfr_clear(pi);
}

// Computes the tangent to `bits` bits. Returns the double nearest to the true value if
// these bits determine it.
std::optional<double> tangent_to(mpfr_prec_t bits, const Rational& degrees) {
  mpfr_t angle;
  init_radians(angle, bits, degrees);
  mpfr_tan(angle, angle, MPFR_RNDN);
  // The tangent amplifies the four roundings of the angle by x / (sin x cos x) < 90 up
  // to 89 degrees, which is less than 10 bits.
  std::optional<double> result;
  if (mpfr_can_round(angle, bits - 10, MPFR_RNDN, MPFR_RNDN, 53) != 0)
    result = mpfr_get_d(angle, MPFR_RNDN);
  mpfr_clear(angle);
  return result;
}

// Returns the double nearest to the sine or the cosine, 0 < degrees <= 45.
double sine_or_cosine(const Rational& degrees, bool sine) {
  if (sine && degrees == 30)
    return 0.5;  // other sines and cosines of rational degrees in (0, 45] are
                 // irrational
  for (mpfr_prec_t bits = 96;; bits *= 2) {
    mpfr_t angle;
    init_radians(angle, bits, degrees);
    if (sine)
      mpfr_sin(angle, angle, MPFR_RNDN);
    else
      mpfr_cos(angle, angle, MPFR_RNDN);
    // The angle has four roundings. Up to 45 degrees sine and cosine do not amplify
    // relative errors, so five roundings need less than four bits.
    const bool certain =
        mpfr_can_round(angle, bits - 4, MPFR_RNDN, MPFR_RNDN, digits) != 0;
    const double value = mpfr_get_d(angle, MPFR_RNDN);
    mpfr_clear(angle);
    if (certain)
      return value;
  }
}

}  // namespace

// Rounds num / den. |num| / den = (whole + rest) * 2^exponent with rest in [0, 1).
// `whole` has 53 bits, or fewer if the result is subnormal. up: whether the rest rounds
// `whole` up.
double rounded_quotient(mpz_srcptr num, mpz_srcptr den, int side) {
  const int sign = mpz_sgn(num);
  if (sign == 0)
    return 0.0;
  static thread_local Scratch scratch;
  const auto bits = [](mpz_srcptr z) {
    return static_cast<long>(mpz_sizeinbase(z, 2));
  };
  // quotient < 2^(bits(num) - bits(den) + 1), so the first exponent leaves 53 or 54
  // bits. If it leaves 54 bits, the next exponent is used.
  long exponent = std::max(bits(num) - bits(den) - digits, min_exponent);
  for (;; ++exponent) {
    mpz_srcptr divisor = den;
    if (exponent <= 0) {
      mpz_mul_2exp(scratch.scaled, num, static_cast<mp_bitcnt_t>(-exponent));
      mpz_abs(scratch.scaled, scratch.scaled);
      mpz_tdiv_qr(scratch.quotient, scratch.remainder, scratch.scaled, divisor);
    } else {
      mpz_mul_2exp(scratch.scaled, den, static_cast<mp_bitcnt_t>(exponent));
      divisor = scratch.scaled;
      mpz_tdiv_qr(scratch.quotient, scratch.remainder, num, divisor);
      mpz_abs(scratch.quotient, scratch.quotient);
      mpz_abs(scratch.remainder, scratch.remainder);
    }
    if (bits(scratch.quotient) > digits)
      continue;
    bool up = side * sign > 0 && mpz_sgn(scratch.remainder) != 0;
    if (side == 0) {  // to the nearest, ties to even
      mpz_mul_2exp(scratch.remainder, scratch.remainder, 1);
      const int half = mpz_cmp(scratch.remainder, divisor);
      up = half > 0 || (half == 0 && mpz_odd_p(scratch.quotient) != 0);
    }
    const double whole = mpz_get_d(scratch.quotient) + (up ? 1.0 : 0.0);
    const double rounded =
        std::ldexp(whole, static_cast<int>(std::min(exponent, 2000L)));
    const bool towards_zero = side * sign < 0;
    return sign * (towards_zero ? std::min(rounded, std::numeric_limits<double>::max())
                                : rounded);
  }
}

Vec2 direction_of_degrees(const Rational& degrees) {
  // Reduces the angle exactly to octants: degrees = 90 quarter + rest, |rest| <= 45.
  const Rational quarters = degrees / 90 + Rational(1, 2);
  Integer whole;
  mpz_fdiv_q(whole.mpz(), mpq_numref(quarters.mpq()), mpq_denref(quarters.mpq()));
  const Rational rest = degrees - 90 * Rational(whole);
  Vec2 turned(1.0, 0.0);
  if (rest != 0) {
    const Rational size = rest < 0 ? Rational(-rest) : rest;
    turned = {sine_or_cosine(size, false), sine_or_cosine(size, true)};
    if (rest < 0)
      turned.y() = -turned.y();
  }
  const unsigned long quarter = mpz_fdiv_ui(whole.mpz(), 4);
  for (unsigned long i = 0; i < quarter; ++i)
    turned = Vec2(0.0 - turned.y(), turned.x());
  return turned;
}

double negative_logarithm(double u) {
  static thread_local const MpfrCache cache;
  mpfr_t value;
  mpfr_init2(value, digits);
  mpfr_set_d(value, u, MPFR_RNDN);
  mpfr_log(value, value, MPFR_RNDN);
  const double result = 0.0 - mpfr_get_d(value, MPFR_RNDN);
  mpfr_clear(value);
  return result;
}

Rational rational(const Decimal& decimal) {
  const CGAL::Gmpz whole(decimal.digits());
  const long exponent = decimal.exponent();
  CGAL::Gmpz scale;
  mpz_ui_pow_ui(scale.mpz(), 10UL,
                static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(whole, scale) : Rational(whole * scale);
}

Point rational(const DecimalPoint& point) {
  return {rational(point.x), rational(point.y)};
}

Integer common_denominator(std::initializer_list<Rational> values) {
  Integer common = 1;
  for (const Rational& value : values)
    mpz_lcm(common.mpz(), common.mpz(), mpq_denref(value.mpq()));
  return common;
}

double nearest(const Rational& value) { return rounded_towards(value, 0); }

Vec2 nearest(const Point& point) { return {nearest(point.x()), nearest(point.y())}; }

double rounded_towards(const Rational& value, int side) {
  return rounded_quotient(mpq_numref(value.mpq()), mpq_denref(value.mpq()), side);
}

double rounded_towards(const Fraction& value, int side) {
  return rounded_quotient(value.num.mpz(), value.den.mpz(), side);
}

double rounded_place(const Integer& from, const Integer& length, const Integer& unit,
                     const Fraction& s, int side) {
  static thread_local Scratch scratch;
  mpz_mul(scratch.quotient, from.mpz(), s.den.mpz());
  mpz_addmul(scratch.quotient, length.mpz(), s.num.mpz());
  mpz_mul(scratch.scaled, unit.mpz(), s.den.mpz());
  return rounded_quotient(scratch.quotient, scratch.scaled, side);
}

double tangent_of_degrees(const Rational& degrees) {
  // Only 0 and 45 degrees have rational tangents, so the loop ends for all other
  // angles.
  if (degrees == 0)
    return 0.0;
  for (mpfr_prec_t bits = 96;; bits *= 2) {
    if (const auto tangent = tangent_to(bits, degrees))
      return *tangent;
  }
}

}  // namespace blocks::geometry::exact
