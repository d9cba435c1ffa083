#include "geometry/exact/numbers.hpp"

#include <gmp.h>
#include <mpfr.h>

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

double round_rational(const Rational& value, mpfr_rnd_t mode) {
  const DoubleRange range;
  MPFR_DECL_INIT(result, 53);
  const int ternary = mpfr_set_q(result, value.mpq(), mode);
  mpfr_subnormalize(result, ternary, mode);
  return mpfr_get_d(result, mode);
}

// Far more than 53 bits, so that rounding the tangent to a double rounds the true one.
constexpr mpfr_prec_t angle_bits = 320;

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

double nearest(const Rational& value) { return round_rational(value, MPFR_RNDN); }

Vec2 nearest(const Point& point) { return {nearest(point.x()), nearest(point.y())}; }

double rounded_towards(const Rational& value, int side) {
  return round_rational(value,
                        side < 0 ? MPFR_RNDD : (side > 0 ? MPFR_RNDU : MPFR_RNDN));
}

double tangent_of_degrees(const Rational& degrees) {
  MPFR_DECL_INIT(angle, angle_bits);
  MPFR_DECL_INIT(pi, angle_bits);
  mpfr_set_q(angle, degrees.mpq(), MPFR_RNDN);
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_mul(angle, angle, pi, MPFR_RNDN);
  mpfr_div_ui(angle, angle, 180, MPFR_RNDN);
  mpfr_tan(angle, angle, MPFR_RNDN);
  return mpfr_get_d(angle, MPFR_RNDN);
}

}  // namespace blocks::geometry::exact
