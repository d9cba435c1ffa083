// Bounds of the motion of blocks. They determine how long kept decisions hold
// (docs/kept-decisions.md).
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "model/blocks.hpp"
#include "model/kept_decisions.hpp"

namespace blocks::dynamics {

/// The net motion of all blocks since the beginning of a phase.
struct MotionBounds {
  bool rigid = true;
  /// (n) [L] longest arm of the undeformed block, rounded up
  std::vector<double> longest;
  /// [L] bound of the error of a corner that comes from rounding its arm
  double rounding = 0.0;
  /// [L] An upper bound of the motion of each block since the beginning of the phase.
  /// It is the sum over the steps of the largest value, over all blocks, of the motion
  /// of the centroid plus twice the change of the longest arm.
  double most = 0.0;
  Eigen::Matrix2Xd centroid;  ///< [L] (2, n) at the beginning of the phase
  Eigen::Matrix4Xd gradient;  ///< (4, n) at the beginning of the phase

  /// Adds a step to `most`. bound: Displacement::bound, or infinity if the state is not
  /// finite.
  void grow(double bound) { most += bound + 0x1p-52 * most; }
  /// Takes the arms of these blocks and begins a phase.
  void start(const Blocks& blocks, bool rigid_blocks);
  /// Takes in the pieces of blocks that have split. Their motion counts from now on.
  /// changed: (n) whether a block is a piece.
  void take_in(const Blocks& blocks, const std::vector<char>& changed);
  /// Begins a phase at the current positions of the blocks.
  void begin_phase(const Blocks& blocks);
  /// Begins a phase at other positions, (blocks).
  void begin_phase(const std::vector<KeptPose>& start);
  /// Returns the positions at the beginning of the phase, (blocks).
  std::vector<KeptPose> poses() const;

  /// Returns the motion of the centroid of block b, [L].
  Vec2 shift(const Blocks& blocks, int b) const {
    return blocks.centroid.col(b) - centroid.col(b);
  }
  /// Returns an upper bound of twice the motion of any arm of block b, [L]. A rotation
  /// moves a unit arm by the norm of the first column of the difference of the
  /// gradients.
  double turn(const Blocks& blocks, int b) const {
    return turn(blocks, b, &gradient(0, b));
  }
  /// The same since the block had another gradient, `then`.
  double turn(const Blocks& blocks, int b, const double* then) const {
    const double* const now = &blocks.gradient(0, b);
    double sum = std::abs(now[0] - then[0]) + std::abs(now[2] - then[2]);
    if (!rigid)
      sum += std::abs(now[1] - then[1]) + std::abs(now[3] - then[3]);
    return 2.0000001 * longest[b] * sum;
  }
};

}  // namespace blocks::dynamics
