// Statistics agree with values worked out by hand.
#include "quantities/statistic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace blocks::quantities {
namespace {

double value(const std::string& name, std::vector<double> values) {
  Statistic statistic;
  EXPECT_TRUE(Statistic::parse(name, statistic)) << name;
  EXPECT_EQ(statistic.name(), name);
  return reduce(statistic, values);
}

TEST(Statistic, ReducesValues) {
  const std::vector<double> values = {7, 1, 4, 10};
  EXPECT_EQ(value("sum", values), 22);
  EXPECT_EQ(value("mean", values), 5.5);
  EXPECT_EQ(value("min", values), 1);
  EXPECT_EQ(value("max", values), 10);
}

// The p-th percentile of 1, 4, 7, 10 is at the index 3 p / 100.
TEST(Statistic, InterpolatesPercentilesBetweenTwoValues) {
  const std::vector<double> values = {7, 1, 4, 10};
  EXPECT_EQ(value("p0", values), 1);
  EXPECT_EQ(value("p50", values), 5.5);
  EXPECT_DOUBLE_EQ(value("p90", values), 7 + 0.7 * 3);
  EXPECT_DOUBLE_EQ(value("p2.5", values), 1 + 0.075 * 3);
  EXPECT_EQ(value("p100", values), 10);
  EXPECT_EQ(value("p90", {3}), 3);
}

TEST(Statistic, IsReadInAnyCase) {
  Statistic statistic;
  EXPECT_TRUE(Statistic::parse("P90", statistic));
  EXPECT_EQ(statistic.name(), "p90");
  EXPECT_TRUE(Statistic::parse("Max", statistic));
  EXPECT_EQ(statistic.name(), "max");
}

TEST(Statistic, RefusesOtherNames) {
  Statistic statistic;
  for (const char* name : {"p", "p101", "p-1", "p.", "p1.2.3", "median", "", "PP90",
                           "p9999999999999999999"})
    EXPECT_FALSE(Statistic::parse(name, statistic)) << name;
}

TEST(Statistic, OfANumberThatIsNoneIsNone) {
  for (const char* name : {"sum", "mean", "min", "max", "p50"})
    EXPECT_TRUE(
        std::isnan(value(name, {1, std::numeric_limits<double>::quiet_NaN(), 2})))
        << name;
}

}  // namespace
}  // namespace blocks::quantities
