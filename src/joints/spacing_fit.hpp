// The law of the spacings of parallel tracks, from the tracks that a window shows.
#pragma once

#include <vector>

#include "joints/estimate.hpp"

namespace blocks::joints {

/// Tracks along one or several lines across them.
struct SpacingSample {
  std::vector<double> spacings;  ///< [L] between neighbours
  /// [L] from the first and the last track of each line to the ends of the line.
  std::vector<double> beyond;
  int lines = 1;
  double length = 0.0;      ///< [L] of the lines
  double resolution = 0.0;  ///< [L] spacings that differ by less are equal
  int tracks = 0;
};

/// JSET's laws of spacing.
struct SpacingFit {
  bool exponential = true;       ///< NEGEXP, otherwise UNIFORM
  Estimate mean;                 ///< [L]
  Estimate half_range{0, 0, 0};  ///< [L] of UNIFORM
};

/// Fits both laws and returns the one with the larger evidence. The mean is NaN without
/// tracks.
SpacingFit fit_spacing(const SpacingSample& sample);

}  // namespace blocks::joints
