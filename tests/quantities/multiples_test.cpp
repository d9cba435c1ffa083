// Multiples of an interval are the doubles nearest to the decimals that a user expects.
#include "quantities/multiples.hpp"

#include <gtest/gtest.h>

#include <string>

namespace blocks::quantities {
namespace {

TEST(Multiples, AreTheNearestDoublesOfTheDecimals) {
  EXPECT_EQ(Multiples(0.1).at(3), 0.3);
  EXPECT_NE(3 * 0.1, 0.3) << "so the product alone is not enough";
  const Multiples thousandths(0.001);
  for (long k = 0; k < 100'000; ++k)
    ASSERT_EQ(thousandths.at(k), std::stod(std::to_string(k) + "e-3")) << k;
  EXPECT_EQ(Multiples(2.5e7).at(4), 1e8);
}

TEST(Multiples, OfLongDecimalsAreProducts) {
  EXPECT_EQ(Multiples(1.0 / 3.0).at(1'000'003), 1'000'003 * (1.0 / 3.0));
}

TEST(Multiples, BeginAtTheTimeItself) {
  EXPECT_EQ(Multiples(0.1).first_from(0.0), 0);
  EXPECT_EQ(Multiples(0.1).first_from(0.25), 3);
  EXPECT_EQ(Multiples(0.1).first_from(0.3), 3);
}

// 0.1 * 3 is greater than 0.3, and ten steps of 0.1 are less than 1.
TEST(Multiples, ForgiveTheRoundingOfTimes) {
  EXPECT_EQ(Multiples(0.1).first_from(0.1 * 3), 3);
  double time = 0.0;
  for (int step = 0; step < 10; ++step)
    time += 0.1;
  ASSERT_LT(time, 1.0);
  EXPECT_TRUE(Multiples(0.1).has_come(10, time));
  EXPECT_FALSE(Multiples(0.1).has_come(10, 0.99999));
}

}  // namespace
}  // namespace blocks::quantities
