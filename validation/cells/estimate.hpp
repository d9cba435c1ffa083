// Estimates with standard errors from independent networks.
#pragma once

#include <vector>

#include "validation/cells/sample.hpp"

namespace blocks::validation {

/// A function of the sums over all networks, such as a ratio of two of them.
using Statistic = double (*)(const Sums&);

/// An estimate from n independent networks.
struct Estimate {
  double value = 0.0;
  double error = 0.0;  ///< standard error
  int count = 0;       ///< n

  /// Returns the half width of the confidence interval of this level, by Student's law.
  double half_width(double level) const;
  /// Returns (value - exact) / error.
  double z(double exact) const { return (value - exact) / error; }
};

/// Estimates by the jackknife: leaves out one network after the other. This corrects
/// the bias of ratios of order 1/n. Cells of one network depend on each other, so the
/// network is the unit.
Estimate jackknife(const std::vector<Sums>& samples, const Statistic& statistic);

/// Returns the limit of |z| that one of `comparisons` true rows exceeds with at most
/// this probability (Bonferroni). Each row has an estimate from `count` networks.
double family_limit(double probability, int comparisons, int count);

}  // namespace blocks::validation
