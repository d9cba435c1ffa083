// Statistics of samples: analytic answers, and coverage of the intervals.
#include "report/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace blocks::report {
namespace {

constexpr double rounding = 1e-12;

// The square of the normal quantile is 3.84.
TEST(Statistics, WilsonOfZeroHitsEndsAtItsClosedForm) {
  for (const std::size_t n : {1UL, 10UL, 384UL}) {
    const Interval share = wilson(0, n);
    EXPECT_EQ(share.low, 0.0);
    EXPECT_NEAR(share.high,
                3.841458820694124 / (static_cast<double>(n) + 3.841458820694124),
                rounding);
    EXPECT_NEAR(wilson(n, n).low, 1.0 - share.high, rounding);
    EXPECT_EQ(wilson(n, n).high, 1.0);
  }
  EXPECT_TRUE(std::isnan(wilson(0, 0).low));
}

// Values of printed tables.
TEST(Statistics, StudentQuantilesAreThoseOfTables) {
  EXPECT_NEAR(student_quantile(2), 12.7062, 5e-5);
  EXPECT_NEAR(student_quantile(11), 2.2281, 5e-5);
  EXPECT_NEAR(student_quantile(1001), 1.9623, 5e-5);
  EXPECT_TRUE(std::isnan(student_quantile(1)));
}

TEST(Statistics, SummaryOfAFewNumbers) {
  const Summary some = summarize({4.0, no_number, 1.0, 3.0, 2.0, INFINITY});
  EXPECT_EQ(some.n, 4U);
  EXPECT_EQ(some.mean, 2.5);
  EXPECT_NEAR(some.standard_deviation, std::sqrt(5.0 / 3.0), rounding);
  EXPECT_NEAR(some.mean_interval.high - 2.5,
              student_quantile(4) * std::sqrt(5.0 / 3.0) / 2.0, rounding);
  EXPECT_EQ(some.median.value, 2.5);
  EXPECT_NEAR(some.low.value, 1.15, rounding);
  EXPECT_EQ(some.min_at, 2U);
  EXPECT_EQ(some.max_at, 0U);
}

TEST(Statistics, OneValueHasNoSpreadAndNoneHasNothing) {
  const Summary one = summarize({7.0, no_number});
  EXPECT_EQ(one.mean, 7.0);
  EXPECT_TRUE(std::isnan(one.standard_deviation));
  EXPECT_TRUE(std::isnan(one.mean_interval.low));
  EXPECT_TRUE(std::isnan(summarize({}).mean));
  EXPECT_TRUE(std::isnan(summarize({}).median.value));
}

// A sum of squares minus the square of a sum would lose all digits here.
TEST(Statistics, AFarOriginCostsNoDigits) {
  const Summary far = summarize({1e9 + 1.0, 1e9 + 2.0, 1e9 + 3.0});
  EXPECT_EQ(far.mean, 1e9 + 2.0);
  EXPECT_EQ(far.standard_deviation, 1.0);
  EXPECT_EQ(summarize({0.1, 0.1, 0.1}).standard_deviation, 0.0);
  EXPECT_EQ(summarize({0.1, 0.1, 0.1}).mean, 0.1);
}

// For the median of six values both tails are 1 / 64, and for five values 1 / 32.
TEST(Statistics, IntervalsOfQuantilesNeedEnoughValues) {
  EXPECT_EQ(quantile({1, 2, 3, 4, 5, 6}, 0.5).interval.low, 1.0);
  EXPECT_EQ(quantile({1, 2, 3, 4, 5, 6}, 0.5).interval.high, 6.0);
  EXPECT_TRUE(std::isnan(quantile({1, 2, 3, 4, 5}, 0.5).interval.low));
  EXPECT_TRUE(std::isnan(quantile({1, 2, 3, 4, 5}, 0.5).interval.high));
  // The 5 % quantile of 20 values: P(B = 0) = 36 %, P(B >= 4) = 1.6 %.
  std::vector<double> values(20);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<double>(i + 1);
  EXPECT_TRUE(std::isnan(quantile(values, 0.05).interval.low));
  EXPECT_EQ(quantile(values, 0.05).interval.high, 4.0);
  EXPECT_EQ(quantile(values, 0.95).interval.low, 17.0);
}

TEST(Statistics, NeededRunsAreTheFewestThatReachThePrecision) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(3.0, 1.0);
  std::vector<double> values(30);
  for (double& value : values)
    value = normal(random);
  const Summary sample = summarize(values);
  for (const Precision& wanted : {Precision{0.05, true}, Precision{0.5, false},
                                  Precision{100.0, false}, Precision{0.4, true}}) {
    const double half =
        wanted.half_width * (wanted.relative ? std::abs(sample.mean) : 1.0);
    const auto reached = [&](std::size_t n) {
      return student_quantile(n) * sample.standard_deviation /
                 std::sqrt(static_cast<double>(n)) <=
             half;
    };
    std::size_t n = 2;
    while (!reached(n))
      ++n;
    EXPECT_EQ(needed_runs(sample, wanted), n) << wanted.words();
  }
  EXPECT_EQ(needed_runs(summarize({1.0, 1.0}), {0.05, true}), 2U);
  EXPECT_EQ(needed_runs(summarize({-1.0, 1.0}), {0.05, true}), std::nullopt);
  EXPECT_EQ(needed_runs(summarize({1.0}), {0.05, true}), std::nullopt);
}

TEST(Statistics, PrecisionIsANumberOrAPart) {
  EXPECT_EQ(Precision::parse("5%").half_width, 0.05);
  EXPECT_TRUE(Precision::parse("5 %").relative);
  EXPECT_FALSE(Precision::parse("0.01").relative);
  for (const char* wrong : {"", "%", "0", "-5%", "nan", "five", "5%%", "inf"})
    EXPECT_THROW(Precision::parse(wrong), std::runtime_error) << wrong;
}

TEST(Statistics, PairedDifferencesLeaveOutPairsWithoutValues) {
  const Summary difference = paired_difference({1, 2, no_number, 4}, {2, 4, 6, 8});
  EXPECT_EQ(difference.n, 3U);
  EXPECT_NEAR(difference.mean, 7.0 / 3.0, rounding);
  EXPECT_THROW(paired_difference({1}, {1, 2}), std::invalid_argument);
}

// 1.4 % is two standard deviations of the share of 1,000 sets.
TEST(Statistics, IntervalsCoverTheTruth) {
  std::mt19937_64 random(20);
  std::normal_distribution<double> normal(10.0, 2.0);
  const int sets = 1000;
  int mean = 0, median = 0, low = 0;
  for (int set = 0; set < sets; ++set) {
    std::vector<double> values(100);
    for (double& value : values)
      value = normal(random);
    const Summary sample = summarize(values);
    const auto covers = [](const Interval& interval, double truth) {
      return interval.low <= truth && truth <= interval.high ? 1 : 0;
    };
    mean += covers(sample.mean_interval, 10.0);
    median += covers(sample.median.interval, 10.0);
    low += covers(sample.low.interval, 10.0 - 2.0 * 1.6448536269514722);
  }
  EXPECT_NEAR(mean, 950, 14);
  EXPECT_GE(median, 950 - 14);  // at least the confidence
  EXPECT_GE(low, 950 - 14);
}

}  // namespace
}  // namespace blocks::report
