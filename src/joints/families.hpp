// Families of directions: a mixture of von Mises laws of axes
// (docs/joint-statistics.md#families).
#pragma once

#include <vector>

namespace blocks::joints {

/// One component: the doubled angle has the von Mises law
/// exp(kappa cos 2(a - mean)) / (2 pi I0(kappa)).
struct Family {
  double mean = 0.0;    ///< degrees from x, 0 <= mean < 180
  double kappa = 0.0;   ///< concentration, 0: isotropic
  double weight = 1.0;  ///< part of the traces, 0 to 1
};

/// A mixture, and which component each direction belongs to.
struct Mixture {
  std::vector<Family> families;  ///< by ascending mean
  /// Family of each direction, from 0; -1: scattered, because its component prefers no
  /// direction.
  std::vector<int> member;
  double log_likelihood = 0.0;  ///< of the directions, per radian of the doubled angle
  double bic = 0.0;             ///< (3 k - 1) ln n - 2 log_likelihood
  int components = 0;           ///< k, before any were joined
};

/// The largest number of families.
inline constexpr int max_families = 6;

/// A component with a smaller mean resultant (0: isotropic, 1: all directions equal)
/// has no preferred direction, as in the rose of a figure.
inline constexpr double min_resultant = 0.4;

/// Fits 0 to `max` components by expectation and maximisation, and takes the fit with
/// the smallest bic. The result depends on nothing but the directions. Members of
/// components whose mean resultant is below min_resultant are scattered. Other
/// components that describe one family are joined (merge_families).
Mixture find_families(const std::vector<double>& degrees, int max = max_families);

}  // namespace blocks::joints
