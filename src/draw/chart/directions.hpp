// Statistics of the directions of joints or cracks, which a rose shows.
#pragma once

#include <map>
#include <optional>
#include <vector>

namespace blocks::draw {

/// Directions of one group, weighted by length. They are axes: 0 and 180 degrees are
/// the same.
struct GroupDirections {
  std::vector<double> sectors;  ///< share of all lengths in each sector of the rose
  double share = 0.0;           ///< of the length of all groups, 0 to 1
  double mean = 0.0;            ///< degrees from the x axis, anticlockwise, 0 to 180
  /// Circular standard deviation [degrees]; none if there is no preferred direction.
  std::optional<double> deviation;
};

struct Directions {
  std::map<int, GroupDirections> groups;  ///< by id, from 1
  double sector = 10.0;  ///< width [degrees]; sector k is centred at k times the width
};

/// A side, a crack or a trace: a group to which it belongs, direction and length.
struct DirectedLength {
  int group = 0;
  double direction = 0.0, length = 0.0;  ///< degrees, 0 to 180; [L]
};

/// Returns the directions of all groups, weighted by length. The sum of the lengths is
/// positive.
Directions direction_statistics(const std::vector<DirectedLength>& lengths);

/// Returns the median of numbers; 0 without numbers.
double median_of(std::vector<double> values);

}  // namespace blocks::draw
