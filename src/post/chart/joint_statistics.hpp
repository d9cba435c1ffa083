// Statistics of the joints of a frame: directions of the sides with a joint id, and
// shapes of the blocks that have such sides.
#pragma once

#include <vector>

#include "draw/chart/directions.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

/// A side counts once for each block that has it, so a joint between two blocks has
/// twice its length. Blocks without a joint are left out.
struct JointStatistics {
  draw::Directions directions;  ///< groups are the joint ids, without 0
  std::vector<double> area;     ///< [L^2] of each block
  std::vector<double> aspect;  ///< >= 1: long to short side of the equivalent rectangle
  std::vector<double> sides;   ///< number of sides of each block
};

/// Throws std::runtime_error if no side has a joint id, or no block has an area.
JointStatistics joint_statistics(const Frame& frame);

}  // namespace blocks::post
