#include "study/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace blocks::study {

Estimate rate(long k, long n) {
  constexpr double z = 1.959963984540054;  // 97.5 % of the normal distribution
  const double count = static_cast<double>(n), p = static_cast<double>(k) / count;
  const double centre = p + z * z / (2.0 * count);
  const double half =
      z * std::sqrt(p * (1.0 - p) / count + z * z / (4.0 * count * count));
  const double scale = 1.0 / (1.0 + z * z / count);
  // The limits are exact at the ends: for 0 of 100, rounding must not leave a lower
  // limit above 0.
  return {p, k == 0 ? 0.0 : (centre - half) * scale,
          k == n ? 1.0 : (centre + half) * scale};
}

Estimate mean(const std::vector<double>& values, std::uint64_t seed) {
  if (values.empty())
    return {};
  if (values.size() == 1)
    return {values[0], not_asked, not_asked};
  const std::size_t n = values.size();
  const double count = static_cast<double>(n);
  constexpr std::size_t resamples = 1000;
  std::vector<double> means;
  means.reserve(resamples);
  std::mt19937_64 random(seed);  // the standard fixes its numbers
  for (std::size_t r = 0; r < resamples; ++r) {
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      sum += values[static_cast<std::size_t>(static_cast<double>(random() >> 11) *
                                             0x1p-53 * count)];
    means.push_back(sum / count);
  }
  std::sort(means.begin(), means.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {sum / count, means[24], means[974]};
}

Estimate median(std::vector<double> values) {
  if (values.empty())
    return {};
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  // The j-th smallest value exceeds the median if fewer than j of n coin tosses are
  // heads. j is the largest number that keeps this probability below 2.5 %.
  const double count = static_cast<double>(n);
  double below = 0.0;
  std::size_t j = 0;
  for (;; ++j) {
    const double k = static_cast<double>(j);
    below += std::exp(std::lgamma(count + 1.0) - std::lgamma(k + 1.0) -
                      std::lgamma(count - k + 1.0) - count * std::numbers::ln2);
    if (below > 0.025)
      break;
  }
  const double middle = 0.5 * (values[(n - 1) / 2] + values[n / 2]);
  if (j == 0)
    return {middle, not_asked, not_asked};
  return {middle, values[j - 1], values[n - j]};
}

}  // namespace blocks::study
