#include "geometry/exact/numbers.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <limits>

namespace blocks::geometry::exact {
namespace {

TEST(Rounding, LeavesTheRationalsForTheNearestDouble) {
  const Rational ulp(std::ldexp(1.0, -52));
  EXPECT_EQ(nearest(Rational(1) + ulp / Rational(2)), 1.0);  // tie to even
  EXPECT_EQ(nearest(Rational(1) + ulp * Rational(3, 2)), 1.0 + std::ldexp(1.0, -51));
  EXPECT_EQ(nearest(Rational(1, 10)), 0.1);
  EXPECT_EQ(nearest(Rational(-1, 3)), -1.0 / 3.0);
}

TEST(Rounding, IsRightAmongSubnormalsAndAtTheEnds) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(nearest(Rational(tiny) / Rational(2)), 0.0);
  EXPECT_EQ(nearest(Rational(tiny) * Rational(3, 2)), 2.0 * tiny);
  // Between two subnormals 53 bits would round twice: just above a tie.
  const Rational above =
      Rational(tiny) * (Rational(5, 2) + Rational(std::ldexp(1, -60)));
  EXPECT_EQ(nearest(above), 3.0 * tiny);
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(nearest(Rational(largest)), largest);
  EXPECT_TRUE(std::isinf(nearest(Rational(largest) * Rational(2))));
}

TEST(Rounding, DirectedRoundingEnclosesTheValueByOneUlp) {
  for (const Rational& r : {Rational(1, 3), Rational(-7, 10), Rational(22, 7)}) {
    const double low = rounded_towards(r, -1);
    const double high = rounded_towards(r, 1);
    EXPECT_TRUE(Rational(low) < r && r < Rational(high));
    EXPECT_EQ(std::nextafter(low, 10.0), high);
  }
  EXPECT_EQ(rounded_towards(Rational(3, 4), -1), 0.75);
  EXPECT_EQ(rounded_towards(Rational(3, 4), 1), 0.75);
}

TEST(Tangent, IsExactWhereItIsRational) {
  EXPECT_EQ(tangent_of_degrees(Rational(0)), 0.0);
  EXPECT_EQ(tangent_of_degrees(Rational(45)), 1.0);
  EXPECT_EQ(tangent_of_degrees(Rational(-45)), -1.0);
  EXPECT_EQ(tangent_of_degrees(Rational(60)), std::sqrt(3.0));
}

TEST(Tangent, IsTheDoubleNearestToTheTrueOne) {
  // Judge: the same to 400 bits by another route, sine over cosine.
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
  EXPECT_GT(differs_from_libm, 0);  // why libm is not asked
}

TEST(Fraction, ComparesAndRoundsWithoutBeingReduced) {
  EXPECT_FALSE(Fraction(6, 4) < Fraction(3, 2));
  EXPECT_FALSE(Fraction(3, 2) < Fraction(-6, -4));
  EXPECT_TRUE(Fraction(1, -3) < Fraction(-2, 7));
  EXPECT_EQ(rounded_towards(Fraction(10, 100), 0), 0.1);
  EXPECT_EQ(rounded_towards(Fraction(-5, 15), 1), rounded_towards(Rational(-1, 3), 1));
  EXPECT_EQ(rounded_towards(Fraction(0, 5), -1), 0.0);
}

}  // namespace
}  // namespace blocks::geometry::exact
