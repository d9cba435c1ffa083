// Statistics of the joints of a frame: directions of the sides with a joint id, and
// shapes of the blocks that have such sides.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "post/results_reader.hpp"

namespace blocks::post {

/// Directions of one joint, weighted by length. They are axes: 0 and 180 degrees are
/// the same.
struct JointDirections {
  std::vector<double> sectors;  ///< share of all lengths in each sector of the rose
  double share = 0.0;           ///< of the length of all joints, 0 to 1
  double mean = 0.0;            ///< degrees from the x axis, anticlockwise, 0 to 180
  /// Circular standard deviation [degrees]; none if there is no preferred direction.
  std::optional<double> deviation;
};

/// A side counts once for each block that has it, so a joint between two blocks has
/// twice its length. Blocks without a joint are left out.
struct JointStatistics {
  std::map<int, JointDirections> joints;  ///< by id, without 0
  double sector = 10.0;  ///< width [degrees]; sector k is centred at k times the width
  std::vector<double> area;    ///< [L^2] of each block
  std::vector<double> aspect;  ///< >= 1: long to short side of the equivalent rectangle
  std::vector<double> sides;   ///< number of sides of each block
};

/// A side or a crack: a group to which it belongs, direction and length.
struct DirectedLength {
  int group = 0;
  double direction = 0.0, length = 0.0;  ///< degrees, 0 to 180; [L]
};

/// Returns the directions of all groups, weighted by length; all other members are
/// empty. The sum of the lengths is positive.
JointStatistics direction_statistics(const std::vector<DirectedLength>& lengths);

/// Throws std::runtime_error if no side has a joint id, or no block has an area.
JointStatistics joint_statistics(const Frame& frame);

/// Returns the median of numbers; 0 without numbers.
double median_of(std::vector<double> values);

}  // namespace blocks::post
