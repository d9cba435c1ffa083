// The cracks that a results file records (docs/cracks.md#the-record).
#pragma once

#include <Eigen/Core>

namespace blocks::post {

/// One block that has split in two. Blocks count from 1.
struct Crack {
  long step = 0;           ///< number of steps made
  double time = 0.0;       ///< [T]
  int parent = 0;          ///< the larger piece, which keeps the number of the block
  int child = 0;           ///< the other piece, a new block
  bool by_points = false;  ///< split by two opposite contact forces, not by stress
  double stress = 0.0;     ///< [F/L^2] tension that reached the strength
  Eigen::Vector2d from = {0, 0}, to = {0, 0};  ///< [L] ends of the chord at that time
  double moved = 0.0;  ///< [L] largest distance from a crossing to its corner
  double parent_area = 0.0, child_area = 0.0;  ///< [L^2] of the two pieces
  // [F L] of the block, and of both pieces together
  double kinetic_before = 0.0, kinetic_after = 0.0;
  double strain_before = 0.0, strain_after = 0.0;

  /// Returns the length of the chord, [L].
  double length() const { return (to - from).norm(); }
  /// Returns the direction of the chord against the x axis, degrees, 0 <= angle < 180.
  double angle() const;
  /// Returns the energy that the crack has released, [F L].
  double released() const {
    return kinetic_before + strain_before - kinetic_after - strain_after;
  }
  /// Returns the rule in words: "stress" or "point loads".
  const char* cause() const { return by_points ? "point loads" : "stress"; }
};

}  // namespace blocks::post
