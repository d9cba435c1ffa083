// Mean trace length and density of traces, corrected for the window
// (docs/joint-statistics.md#trace-lengths).
#pragma once

#include "joints/estimate.hpp"
#include "joints/length_law.hpp"
#include "joints/network.hpp"

namespace blocks::joints {

/// Estimates that assume no law of the lengths. Their intervals come from resampling
/// the pieces with Poisson weights, as if traces were independent.
struct TraceDensity {
  Estimate p20;  ///< [1/L^2] traces per area: half of the visible ends over the area
  Estimate p21;  ///< [1/L] length per area
  Estimate by_ends;  ///< [L] mean length P21 / P20
  /// [L] mean length from counts alone, for any window:
  ///
  ///     area / width * (n1 + 2 n2) / (2 n0 + n1)
  ///
  /// n0, n1, n2: pieces with 0, 1 and 2 hidden ends. For a circle of radius r, area
  /// over width is pi r / 2.
  Estimate by_counts;
};

/// Returns the estimates; mean lengths are NaN without visible ends.
TraceDensity trace_density(const std::vector<Piece>& pieces,
                           const geometry::Polygon& window);

/// A law fitted by maximum likelihood.
struct FittedLaw {
  LengthLaw law;
  Estimate mean;                    ///< [L] with the interval of the profile likelihood
  double log_likelihood = unknown;  ///< NaN: the law cannot be fitted
  int parameters = 1;

  /// Akaike's criterion; the smaller one fits better.
  double aic() const { return 2.0 * parameters - 2.0 * log_likelihood; }
};

/// Fits the law with this form, exponential or lognormal. The log likelihood is NaN if
/// fewer than two traces are complete, because the mean is then not bounded.
FittedLaw fit_length_law(LengthForm form, const LengthSample& sample);

}  // namespace blocks::joints
