// Uniform laws, as JSET has them, fitted to samples of which some values are cut off
// (docs/joint-statistics.md#uniform-laws).
#pragma once

#include <functional>
#include <vector>

#include "joints/estimate.hpp"

namespace blocks::joints {

/// A uniform law from mean - half_range to mean + half_range.
struct UniformFit {
  Estimate mean, half_range;
  /// Logarithm of the integral of the likelihood over d mean / mean and the ratio
  /// half_range / mean from 0 to 1. It is compared with that of an exponential law, the
  /// integral over d mean / mean. Infinite if all values are equal.
  double log_evidence = unknown;
};

/// What is known of the values.
struct UniformSample {
  std::vector<double> values;  ///< at least two
  /// Values that differ by less are equal: the rounding of the file.
  double resolution = 0.0;
  double min = 0.0;  ///< the law has no smaller values; may be -infinity
  /// Logarithm of the other factors of the likelihood for a law from a to b; may be
  /// -infinity. Empty: none.
  std::function<double(double a, double b)> other_factors = {};
};

/// Returns the medians and the central 95 % of the likelihood, weighted with
/// 1 / half_range. For a sample without other factors and without a least value, these
/// intervals are exact: location and scale of the law are then pivots. The largest
/// likelihood is no estimate, because it lies at the end of the interval. The estimates
/// are NaN for fewer than two values.
UniformFit fit_uniform(const UniformSample& sample);

}  // namespace blocks::joints
