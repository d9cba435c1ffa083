// Bounds of the motion of blocks. They determine how long kept decisions hold
// (docs/kept-decisions.md).
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/contact_constants.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Bounds of the motion of all blocks.
struct MotionBounds {
  bool rigid = true;
  /// (n) [L] longest arm of the undeformed block, rounded up
  std::vector<double> longest;
  /// (n) [L] An upper bound of the path of each block. It is the sum over the steps of
  /// the motion of the centroid plus twice the change of the longest arm.
  std::vector<double> path;
  /// [L] bound of the error of a corner that comes from rounding its arm
  double rounding = 0.0;
  /// [L] The same for all blocks: the sum over the steps of the largest value, over all
  /// blocks, that a step adds to `path`.
  double longest_path = 0.0;

  /// Adds a step to `longest_path`. bound: Displacement::bound, or infinity if the
  /// state is not finite.
  void grow(double bound) {
    longest_path += bound + geometry::Certainty::path_rounding * longest_path;
  }
  /// Returns the sum of the paths of two blocks. Their motion
  /// (docs/kept-decisions.md#motion-of-a-pair) grows by no more than this sum.
  double path_of(int a, int b) const { return path[a] + path[b]; }
  /// Takes the arms of these blocks and begins at 0.
  void start(const Blocks& blocks, bool rigid_blocks);
  /// Takes the arms of pieces of blocks that have split. changed: (n) whether a block
  /// is a piece.
  void take_in(const Blocks& blocks, const std::vector<char>& changed);

  /// Returns an upper bound of twice the motion of any arm of block b since it had the
  /// gradient `then`, [L]. A rotation moves a unit arm by the norm of the first column
  /// of the difference of the gradients.
  double turn(const Blocks& blocks, int b, const double* then) const {
    const double* const now = &blocks.gradient(0, b);
    const auto square = [&](int i) { return (now[i] - then[i]) * (now[i] - then[i]); };
    double sum = square(0) + square(2);
    if (!rigid)
      sum += square(1) + square(3);
    return geometry::Certainty::turn_factor * longest[b] * std::sqrt(sum);
  }
  /// Returns the largest singular value of the gradient of block b, rounded up: no arm
  /// is longer than `longest` times this.
  double stretch(const Blocks& blocks, int b) const {
    if (rigid)
      return 1.0;
    const double* const g = &blocks.gradient(0, b);
    const double squares = g[0] * g[0] + g[1] * g[1] + g[2] * g[2] + g[3] * g[3];
    const double twice_area = 2.0 * (g[0] * g[3] - g[1] * g[2]);
    const double gap = (squares - twice_area) * (squares + twice_area);
    return geometry::Certainty::shift_factor *
           std::sqrt(0.5 * (squares + std::sqrt(std::max(gap, 0.0))));
  }

 private:
  void find_rounding();
};

}  // namespace blocks::dynamics
