// Decides which two faces of two convex parts act, and how far the blocks may move
// before that can change (docs/kept-decisions.md). The kernel decides
// eight pairs of parts at a time. It gives no answer where rounding or a neighbour
// could change it.
#pragma once

#include "dynamics/kernels/contact_batch.hpp"

namespace blocks::dynamics {

/// Pairs of parts, one to a lane. Part 0 belongs to the block with the lower number.
/// Unused lanes repeat a pair of another lane.
struct alignas(64) PartPairs {
  /// Pairs with a larger part are decided by the exact rule.
  static constexpr int max_corners = 32;
  /// The corners of each part, clockwise. The rest is filled with its first corner.
  PerLane<int> corner[2][max_corners];
  PerLane<int> block[2];
  PerLane<double> corners[2];  ///< number of corners of each part
  PerLane<double> longest[2];  ///< [L] MotionBounds::longest of each block
  int used_corners = 0;        ///< number of corners of the largest part
  bool rigid = true;
};

/// What is certain about each pair. A margin is a bound of the motion of the two blocks
/// (Validity::distance), [L]: below it the answer cannot change. If the margin is not
/// positive, the answer is in doubt.
struct alignas(64) FacingAnswers {
  PerLane<double> apart;  ///< margin: the parts are apart by more than the slack
  /// Margin: the two faces below act and no others do, unless a third part is near the
  /// contact point.
  PerLane<double> faces;
  /// [L] bound of the rounding error of depths and positions
  PerLane<double> rounding;
  PerLane<double> own;   ///< the part with the axis side, 0 or 1
  PerLane<double> side;  ///< index of the axis side
  /// Index of the side of the other part that faces the axis side. It is -1 if there is
  /// none; then a single corner acts.
  PerLane<double> facing;
  PerLane<double> corner;  ///< index of the deepest corner
  PerLane<double> x, y;    ///< [L] the contact point, on the axis side
  /// [L] A third part that is farther away from the contact point hides nothing.
  PerLane<double> reach;
  /// Margins: a contact does not act, because its corner is beyond an end of the edge
  /// by more than the slack. The first two are for the start and end of the facing side
  /// on the axis side. The last two are for the start and end of the axis side on the
  /// facing side.
  PerLane<double> beyond[4];
};

}  // namespace blocks::dynamics
