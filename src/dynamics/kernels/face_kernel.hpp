// Which two faces of two convex parts act, and how far the blocks may move before that
// can change (docs/contact-rule.md#kept-decisions). The kernel computes eight pairs of
// parts at a time. It gives no answer where rounding or a neighbour could change it.
#pragma once

#include "dynamics/kernels/contact_batch.hpp"

namespace blocks::dynamics {

/// Pairs of parts, at most one to a lane. Part 0 belongs to the block with the lower
/// number. Unused lanes repeat another one.
struct alignas(64) PartPairs {
  /// Parts with more corners are left to the exact rule.
  static constexpr int most_corners = 32;
  /// Clockwise; beyond the last corner of a part its first one, again and again.
  PerLane<int> corner[2][most_corners];
  PerLane<int> block[2];
  PerLane<double> corners[2];  ///< of each part
  PerLane<double> longest[2];  ///< [L] MotionBounds::longest of each block
  int most = 0;                ///< corners of the largest part
  bool rigid = true;
};

/// What is certain of each pair. A margin is the motion of the two blocks
/// (PairMotion::two) below which the answer cannot change, [L]. If it is not positive,
/// the answer is in doubt.
struct alignas(64) FacingAnswers {
  PerLane<double> apart;  ///< margin: the parts are apart by more than the slack
  /// Margin: unless a joint hides them, the faces below act and no others.
  PerLane<double> faces;
  PerLane<double> rounding;  ///< [L] no depth or place is wrong by more
  PerLane<double> own;       ///< 0 or 1: the part of the axis side
  PerLane<double> side;      ///< index of the axis side
  /// Index of the side of the other part that faces it; -1: none, one corner acts.
  PerLane<double> facing;
  PerLane<double> corner;  ///< index of the deepest corner, the start of a side
  /// Margins: the other part's centroid is inside the surface of the joint, which
  /// is open then. In the order start and end of the axis side, start and end of the
  /// facing side; without one, the two joints at the corner.
  PerLane<double> joint[4];
  /// Margins: the contact is beyond an end of its edge by more than the slack. Start
  /// and end of the facing side on the axis side, then the other way round.
  PerLane<double> beyond[4];
};

}  // namespace blocks::dynamics
