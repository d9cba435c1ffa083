// Statistical tests of distributions, for samples with fixed seeds.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace blocks::geometry::testing {

/// Returns the Kolmogorov-Smirnov statistic: the largest distance to a distribution
/// function, times sqrt(n). One in a thousand samples of that law exceeds 1.95.
template <class Law> double ks_distance(std::vector<double> sample, Law law) {
  std::sort(sample.begin(), sample.end());
  const double n = static_cast<double>(sample.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double p = law(sample[i]);
    const double k = static_cast<double>(i);
    distance = std::max({distance, p - k / n, (k + 1.0) / n - p});
  }
  return distance * std::sqrt(n);
}

/// Returns the statistic of two samples: the largest distance between their
/// distribution functions, times sqrt(n m / (n + m)).
inline double ks_distance(std::vector<double> a, std::vector<double> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  const double n = static_cast<double>(a.size());
  const double m = static_cast<double>(b.size());
  double distance = 0.0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double x = std::min(a[i], b[j]);
    while (i < a.size() && a[i] <= x)
      ++i;
    while (j < b.size() && b[j] <= x)
      ++j;
    distance = std::max(
        distance, std::abs(static_cast<double>(i) / n - static_cast<double>(j) / m));
  }
  return distance * std::sqrt(n * m / (n + m));
}

}  // namespace blocks::geometry::testing
