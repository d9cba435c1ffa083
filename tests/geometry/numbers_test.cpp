#include "geometry/exact/numbers.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <limits>
#include <random>

namespace blocks::geometry::exact {
namespace {

TEST(Rounding, GivesTheNearestDouble) {
  const Rational ulp(std::ldexp(1.0, -52));
  EXPECT_EQ(nearest(Rational(1) + ulp / Rational(2)), 1.0);  // A tie rounds to even.
  EXPECT_EQ(nearest(Rational(1) + ulp * Rational(3, 2)), 1.0 + std::ldexp(1.0, -51));
  EXPECT_EQ(nearest(Rational(1, 10)), 0.1);
  EXPECT_EQ(nearest(Rational(-1, 3)), -1.0 / 3.0);
}

TEST(Rounding, IsCorrectForSubnormalsAndOverflow) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(nearest(Rational(tiny) / Rational(2)), 0.0);
  EXPECT_EQ(nearest(Rational(tiny) * Rational(3, 2)), 2.0 * tiny);
  // This is just above a tie. Rounding to 53 bits first would round twice.
  const Rational above =
      Rational(tiny) * (Rational(5, 2) + Rational(std::ldexp(1, -60)));
  EXPECT_EQ(nearest(above), 3.0 * tiny);
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(nearest(Rational(largest)), largest);
  EXPECT_TRUE(std::isinf(nearest(Rational(largest) * Rational(2))));
}

TEST(Rounding, EnclosesTheValueWithinOneUlpIfDirected) {
  for (const Rational& r : {Rational(1, 3), Rational(-7, 10), Rational(22, 7)}) {
    const double low = rounded_towards(r, -1);
    const double high = rounded_towards(r, 1);
    EXPECT_TRUE(Rational(low) < r && r < Rational(high));
    EXPECT_EQ(std::nextafter(low, 10.0), high);
  }
  EXPECT_EQ(rounded_towards(Rational(3, 4), -1), 0.75);
  EXPECT_EQ(rounded_towards(Rational(3, 4), 1), 0.75);
}

/// Returns the quotient rounded by MPFR in the exponent range of a double.
double judged(const Fraction& value, mpfr_rnd_t mode) {
  mpfr_t num, den;
  mpfr_init2(num, mpz_sizeinbase(value.num.mpz(), 2) + 2);
  mpfr_init2(den, mpz_sizeinbase(value.den.mpz(), 2) + 2);
  mpfr_set_z(num, value.num.mpz(), MPFR_RNDN);
  mpfr_set_z(den, value.den.mpz(), MPFR_RNDN);
  const mpfr_exp_t low = mpfr_get_emin(), high = mpfr_get_emax();
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  MPFR_DECL_INIT(result, 53);
  mpfr_subnormalize(result, mpfr_div(result, num, den, mode), mode);
  const double rounded = mpfr_get_d(result, mode);
  mpfr_set_emin(low);
  mpfr_set_emax(high);
  mpfr_clears(num, den, static_cast<mpfr_ptr>(nullptr));
  return rounded;
}

TEST(Rounding, AgreesWithMpfrForQuotientsOfAnyLength) {
  std::mt19937_64 engine(7);
  const auto number = [&engine](int words) {
    Integer z = 0;
    for (int i = 0; i < words; ++i) {
      mpz_mul_2exp(z.mpz(), z.mpz(), 64);
      mpz_add_ui(z.mpz(), z.mpz(), engine());
    }
    return z;
  };
  int subnormal = 0, infinite = 0, exact = 0;
  for (int k = 0; k < 30000; ++k) {
    Integer num = number(1 + static_cast<int>(engine() % 20)), den;
    if (k % 5 == 0) {  // The quotient is a double, a tie, or next to one.
      mpz_tdiv_q_2exp(num.mpz(), num.mpz(), mpz_sizeinbase(num.mpz(), 2) - 54);
      mpz_mul_2exp(num.mpz(), num.mpz(), 3);
      num += Integer(static_cast<int>(engine() % 3) - 1);
      den = 1;
      mpz_mul_2exp(den.mpz(), den.mpz(), engine() % 1130);
    } else {
      den = number(1 + static_cast<int>(engine() % 20)) + Integer(1);
    }
    const Fraction value(k % 2 == 0 ? num : Integer(-num), den);
    const double nearest = rounded_towards(value, 0);
    EXPECT_EQ(nearest, judged(value, MPFR_RNDN)) << k;
    EXPECT_EQ(rounded_towards(value, -1), judged(value, MPFR_RNDD)) << k;
    EXPECT_EQ(rounded_towards(value, 1), judged(value, MPFR_RNDU)) << k;
    subnormal += std::fpclassify(nearest) == FP_SUBNORMAL ? 1 : 0;
    infinite += std::isinf(nearest) ? 1 : 0;
    exact += rounded_towards(value, -1) == rounded_towards(value, 1) ? 1 : 0;
  }
  EXPECT_GT(subnormal, 50);
  EXPECT_GT(infinite, 50);
  EXPECT_GT(exact, 50);
}

TEST(Tangent, IsCorrectlyRoundedForSimpleAngles) {
  EXPECT_EQ(tangent_of_degrees(Rational(0)), 0.0);
  EXPECT_EQ(tangent_of_degrees(Rational(45)), 1.0);
  EXPECT_EQ(tangent_of_degrees(Rational(-45)), -1.0);
  EXPECT_EQ(tangent_of_degrees(Rational(60)), std::sqrt(3.0));
}

TEST(Tangent, AgreesWithMpfr) {
  // The judge computes sine over cosine with 400 bits.
  mpfr_t angle;
  mpfr_t cosine;
  mpfr_inits2(400, angle, cosine, static_cast<mpfr_ptr>(nullptr));
  int differs_from_libm = 0;
  for (int i = -8900; i <= 8900; i += 7) {
    const Rational degrees(i, 100);
    mpfr_const_pi(angle, MPFR_RNDN);
    mpfr_mul_si(angle, angle, i, MPFR_RNDN);
    mpfr_div_ui(angle, angle, 18000, MPFR_RNDN);
    mpfr_sin_cos(angle, cosine, angle, MPFR_RNDN);
    mpfr_div(angle, angle, cosine, MPFR_RNDN);
    const double tangent = tangent_of_degrees(degrees);
    EXPECT_EQ(tangent, mpfr_get_d(angle, MPFR_RNDN)) << i;
    EXPECT_EQ(tangent, -tangent_of_degrees(-degrees));
    differs_from_libm += tangent != std::tan(i * M_PI / 18000.0) ? 1 : 0;
  }
  mpfr_clears(angle, cosine, static_cast<mpfr_ptr>(nullptr));
  EXPECT_GT(differs_from_libm, 0);  // The functions of libm are not exact.
}

TEST(Fraction, IsComparedWithoutBeingReduced) {
  EXPECT_FALSE(Fraction(6, 4) < Fraction(3, 2));
  EXPECT_FALSE(Fraction(3, 2) < Fraction(-6, -4));
  EXPECT_TRUE(Fraction(1, -3) < Fraction(-2, 7));
  Integer tower = 1;  // Doubles cannot distinguish these fractions of 2^60 to 2^1200.
  for (int k = 0; k < 20; ++k) {
    mpz_mul_2exp(tower.mpz(), tower.mpz(), 60);
    EXPECT_TRUE(Fraction(tower, tower + 1) < Fraction(tower + 1, tower));
    EXPECT_TRUE(Fraction(tower, tower + 1) < Fraction(tower + 1, tower + 2));
    EXPECT_FALSE(Fraction(-tower, tower + 1) < Fraction(-tower - 1, tower + 2));
    EXPECT_FALSE(Fraction(tower * 3, (tower + 1) * 3) < Fraction(tower, tower + 1));
  }
}

TEST(Fraction, IsRoundedWithoutBeingReduced) {
  EXPECT_EQ(rounded_towards(Fraction(10, 100), 0), 0.1);
  EXPECT_EQ(rounded_towards(Fraction(-5, 15), 1), rounded_towards(Rational(-1, 3), 1));
  EXPECT_EQ(rounded_towards(Fraction(0, 5), -1), 0.0);
}

}  // namespace
}  // namespace blocks::geometry::exact
