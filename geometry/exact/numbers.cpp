#include "geometry/exact/numbers.hpp"

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace blocks::geometry::exact {
namespace {

// The exponent range of a double for the life of the object. MPFR keeps it per thread.
class DoubleRange {
 public:
  DoubleRange() : low_(mpfr_get_emin()), high_(mpfr_get_emax()) {
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
  }
  ~DoubleRange() {
    mpfr_set_emin(low_);
    mpfr_set_emax(high_);
  }
  DoubleRange(const DoubleRange&) = delete;
  DoubleRange& operator=(const DoubleRange&) = delete;

 private:
  mpfr_exp_t low_;
  mpfr_exp_t high_;
};

// A whole number as it stands, for the life of the object.
class WholeNumber {
 public:
  explicit WholeNumber(const Integer& z) {
    const std::size_t bits = mpz_sizeinbase(z.mpz(), 2);
    mpfr_init2(value_,
               std::max<mpfr_prec_t>(MPFR_PREC_MIN, static_cast<mpfr_prec_t>(bits)));
    mpfr_set_z(value_, z.mpz(), MPFR_RNDN);
  }
  ~WholeNumber() { mpfr_clear(value_); }
  WholeNumber(const WholeNumber&) = delete;
  WholeNumber& operator=(const WholeNumber&) = delete;
  mpfr_srcptr get() const { return value_; }

 private:
  mpfr_t value_;
};

double round_quotient(const Integer& num, const Integer& den, mpfr_rnd_t mode) {
  const WholeNumber n(num);  // before the range of a double: they may exceed it
  const WholeNumber d(den);
  const DoubleRange range;
  MPFR_DECL_INIT(result, 53);
  const int ternary = mpfr_div(result, n.get(), d.get(), mode);
  mpfr_subnormalize(result, ternary, mode);
  return mpfr_get_d(result, mode);
}

mpfr_rnd_t mode_of(int side) {
  return side < 0 ? MPFR_RNDD : (side > 0 ? MPFR_RNDU : MPFR_RNDN);
}

// The tangent to so many bits, and the double nearest to the true one if they suffice.
std::optional<double> tangent_to(mpfr_prec_t bits, const Rational& degrees) {
  mpfr_t angle;
  mpfr_t pi;
  mpfr_inits2(bits, angle, pi, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_q(angle, degrees.mpq(), MPFR_RNDN);
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_mul(angle, angle, pi, MPFR_RNDN);
  mpfr_div_ui(angle, angle, 180, MPFR_RNDN);
  mpfr_tan(angle, angle, MPFR_RNDN);
  // Four roundings of the angle, each relative 2^-bits, grow by x / (sin x cos x) < 90
  // up to 89 degrees: less than 10 bits.
  std::optional<double> result;
  if (mpfr_can_round(angle, bits - 10, MPFR_RNDN, MPFR_RNDN, 53) != 0)
    result = mpfr_get_d(angle, MPFR_RNDN);
  mpfr_clears(angle, pi, static_cast<mpfr_ptr>(nullptr));
  return result;
}

}  // namespace

Rational rational(const Decimal& decimal) {
  const CGAL::Gmpz digits(decimal.digits());
  const long exponent = decimal.exponent();
  CGAL::Gmpz scale;
  mpz_ui_pow_ui(scale.mpz(), 10UL,
                static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(digits, scale) : Rational(digits * scale);
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
  return rounded_towards(Fraction(value), side);
}

double rounded_towards(const Fraction& value, int side) {
  return round_quotient(value.num, value.den, mode_of(side));
}

double tangent_of_degrees(const Rational& degrees) {
  // 0 and 45 degrees are the only ones with rational tangents: the others end here.
  if (degrees == 0)
    return 0.0;
  for (mpfr_prec_t bits = 96;; bits *= 2) {
    if (const auto tangent = tangent_to(bits, degrees))
      return *tangent;
  }
}

}  // namespace blocks::geometry::exact
