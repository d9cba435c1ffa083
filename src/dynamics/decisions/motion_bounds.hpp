// How far blocks have moved, by which kept decisions are known to hold
// (docs/contact-rule.md#kept-decisions).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Net motion of all blocks since the beginning of a phase.
struct MotionBounds {
  bool rigid = true;
  std::vector<double> longest;  ///< (n) [L] longest arm as made, rounded up
  double rounding = 0.0;  ///< [L] no corner is off its place by more because of its arm
  /// [L] No block has moved by more: the sum over the steps of the largest motion of a
  /// centroid plus twice that of the longest arm.
  double most = 0.0;
  Eigen::Matrix2Xd centroid;  ///< [L] (2, n) at the beginning
  Eigen::Matrix4Xd gradient;  ///< (4, n) at the beginning

  /// Adds a step to `most`. bound: Displacement::bound; infinite if it is not finite.
  void grow(double bound) { most += bound + 0x1p-52 * most; }
  /// Takes the shapes of these blocks and begins a phase.
  void start(const Blocks& blocks, bool rigid_blocks);
  /// Begins a phase where the blocks are.
  void begin_phase(const Blocks& blocks);

  /// Motion of the centroid of block b, [L].
  Vec2 shift(const Blocks& blocks, int b) const {
    return blocks.centroid.col(b) - centroid.col(b);
  }
  /// At least twice the motion of any arm of block b, [L]. A rotation moves a unit arm
  /// by the norm of the first column of the difference of the gradients.
  double turn(const Blocks& blocks, int b) const {
    const double* const now = &blocks.gradient(0, b);
    const double* const then = &gradient(0, b);
    double sum = std::abs(now[0] - then[0]) + std::abs(now[2] - then[2]);
    if (!rigid)
      sum += std::abs(now[1] - then[1]) + std::abs(now[3] - then[3]);
    return 2.0000001 * longest[b] * sum;
  }
};

}  // namespace blocks::dynamics
