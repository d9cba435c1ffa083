// Confidence intervals of what a study counts and averages.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace blocks::study {

inline constexpr double not_asked = std::numeric_limits<double>::quiet_NaN();

struct Estimate {
  double value = not_asked;
  double low = not_asked, high = not_asked;  ///< 95 % confidence
};

/// Wilson's score interval for k of n, 0 <= k <= n, n > 0.
Estimate rate(long k, long n);

/// Mean with the percentile bootstrap interval of 1000 resamples; empty: not asked;
/// of one value there is no interval.
Estimate mean(const std::vector<double>& values, std::uint64_t seed);

/// Median with the interval of order statistics, which needs no law of distribution:
/// the j-th smallest and the j-th largest value, j as large as leaves at least 95 %
/// confidence. Of fewer than six values there is none: NaN.
Estimate median(std::vector<double> values);

}  // namespace blocks::study
