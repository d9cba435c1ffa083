// Confidence intervals of what a study counts and averages.
#pragma once

#include <cstdint>
#include <vector>

namespace blocks::study {

struct Estimate {
  double value = 0.0;
  double low = 0.0, high = 0.0;  ///< 95 % confidence
};

/// Wilson's score interval for k of n, 0 <= k <= n; n = 0: 0 to 1 around NaN.
Estimate rate(long k, long n);

/// Mean with the percentile bootstrap interval of 1000 resamples. NaN when empty.
Estimate mean(const std::vector<double>& values, std::uint64_t seed);

/// NaN when empty.
double median(std::vector<double> values);

}  // namespace blocks::study
