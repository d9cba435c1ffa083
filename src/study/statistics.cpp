#include "study/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace blocks::study {
namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
}

Estimate rate(long k, long n) {
  if (n == 0)
    return {nan, 0.0, 1.0};
  constexpr double z = 1.959963984540054;  // 97.5 % of the normal distribution
  const double count = static_cast<double>(n), p = static_cast<double>(k) / count;
  const double centre = p + z * z / (2.0 * count);
  const double half =
      z * std::sqrt(p * (1.0 - p) / count + z * z / (4.0 * count * count));
  const double scale = 1.0 / (1.0 + z * z / count);
  // at the ends exact: rounding must not leave a 0 of 100 above 0
  return {p, k == 0 ? 0.0 : (centre - half) * scale,
          k == n ? 1.0 : (centre + half) * scale};
}

Estimate mean(const std::vector<double>& values, std::uint64_t seed) {
  if (values.empty())
    return {nan, nan, nan};
  const std::size_t n = values.size();
  const double count = static_cast<double>(n);
  constexpr std::size_t resamples = 1000;
  std::vector<double> means;
  means.reserve(resamples);
  std::mt19937_64 random(seed);  // its numbers are those of the standard, everywhere
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

double median(std::vector<double> values) {
  if (values.empty())
    return nan;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace blocks::study
