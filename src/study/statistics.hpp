// Confidence intervals of the counts and averages of a study.
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

/// Returns k / n with Wilson's score interval, 0 <= k <= n, n > 0.
Estimate rate(long k, long n);

/// Returns the mean with the percentile bootstrap interval of 1000 resamples. Without
/// values it returns NaN; for one value there is no interval.
Estimate mean(const std::vector<double>& values, std::uint64_t seed);

/// Returns the median with the interval of order statistics, which assumes no
/// distribution. Its limits are the j-th smallest and the j-th largest value, with the
/// largest j that leaves at least 95 % confidence. There is no interval (NaN) for fewer
/// than six values.
Estimate median(std::vector<double> values);

}  // namespace blocks::study
