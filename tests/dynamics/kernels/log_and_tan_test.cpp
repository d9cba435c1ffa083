// The errors of the logarithm and the tangent of the law of Barton and Bandis.
#include "dynamics/kernels/log_and_tan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace blocks::dynamics {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64,
              "the reference needs more digits than a double");

/// Returns the largest relative error of `found` in units of 2^-52, for many numbers
/// between `low` and `high`, at equal ratios or at equal distances.
double largest_error(double low, double high, bool ratios,
                     const std::function<double(double)>& found,
                     const std::function<long double(long double)>& exact) {
  constexpr int count = 1'000'000;
  double largest = 0.0;
  for (int i = 0; i <= count; ++i) {
    const double part = static_cast<double>(i) / count;
    const double x =
        ratios ? low * std::pow(high / low, part) : low + (high - low) * part;
    const long double right = exact(x);
    const long double error = std::abs(found(x) - right);
    if (error > 0.0L)
      largest = std::max(largest, static_cast<double>(error / right * 0x1p52L));
  }
  return largest;
}

TEST(LogAndTan, ErrorsAreBelowTheirBounds) {
  const auto log10 = [](long double x) { return std::log10(x); };
  const auto tan = [](long double x) { return std::tan(x); };
  const auto own_log10 = [](double x) { return log10_of(x); };
  const auto own_tan = [](double x) { return tan_of(x); };
  const auto small = [](double x) { return small_tan(x); };
  const double log_error =
      std::max({largest_error(1.0, 2.5, false, own_log10, log10),
                largest_error(1.0, 1.0 + 1e-6, false, own_log10, log10),
                largest_error(1.0, 1e6, true, own_log10, log10),
                largest_error(1.0, 1.7e308, true, own_log10, log10)});
  const double tan_error = std::max(largest_error(0.0, 1.24, false, own_tan, tan),
                                    largest_error(1e-300, 1.24, true, own_tan, tan));
  const double small_error = std::max(largest_error(0.0, 0.62, false, small, tan),
                                      largest_error(1e-300, 0.62, true, small, tan));
  EXPECT_LT(log_error, 4.0);
  EXPECT_LT(tan_error, 8.0);
  EXPECT_LT(small_error, 4.0);
}

TEST(LogAndTan, ClosureIntegralIsAccurateForSmallAndLargeClosures) {
  // Below 0.01 the exact value is a series.
  const auto exact = [](long double x) {
    if (x > 0.01L)
      return std::log1p(x) - x / (1.0L + x);
    long double sum = 0.0L;
    for (int n = 12; n >= 2; --n)
      sum = (n % 2 == 0 ? 1.0L : -1.0L) * (n - 1.0L) / n + x * sum;
    return x * x * sum;
  };
  const auto own = [](double x) { return closure_integral(x); };
  const double error = std::max({largest_error(1e-100, 1e100, true, own, exact),
                                 largest_error(1e-3, 10.0, true, own, exact),
                                 largest_error(0.40, 0.43, false, own, exact)});
  EXPECT_LT(error, 32.0);
}

TEST(LogAndTan, SimpleValuesAreExact) {
  EXPECT_EQ(log10_of(1.0), 0.0);
  EXPECT_EQ(tan_of(0.0), 0.0);
  EXPECT_EQ(small_tan(0.0), 0.0);
  EXPECT_EQ(closure_integral(0.0), 0.0);
}

}  // namespace
}  // namespace blocks::dynamics
