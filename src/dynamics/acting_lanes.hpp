// The lanes in which contacts act, and what motion needs of them: which lanes act on
// which block, how far blocks have gone, and how the work is shared among threads.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "dynamics/contact_lanes.hpp"
#include "dynamics/work_split.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// How far each block has gone since decisions began to be kept.
struct Swing {
  bool rigid = true;
  std::vector<double> longest;  ///< (n) [L] longest arm at the start, rounded up
  std::vector<double> sum;      ///< (n) [L] round-off; only grows
  // deformable blocks only
  Eigen::Matrix4Xd shape;  ///< (4, n) by columns: arms over those at the start
  // all blocks
  /// (n) [L] Way of the centroid and twice that of an arm `longest` long in any
  /// direction, rounded up.
  std::vector<double> way;
  double travel = 0.0;  ///< [L] no way has grown by more between two moments

  /// For these blocks as they stand.
  void start(const Blocks& blocks, bool rigid_blocks);
};

/// Which lanes act on each block, block after block, in the order of the list.
struct LanesOfBlocks {
  std::vector<int> first;  ///< (blocks + 1) where those of a block begin
  std::vector<int> lane;

  /// Makes them of the pairs that have lanes; side: &Pair::low or high.
  template <class Pair>
  void sort(int blocks, const std::vector<Pair>& pairs, int Pair::*side) {
    first.assign(blocks + 1, 0);
    for (const Pair& pair : pairs)
      first[pair.*side + 1] += pair.lane >= 0;
    std::partial_sum(first.begin(), first.end(), first.begin());
    lane.resize(first.back());
    for (const Pair& pair : pairs)
      if (pair.lane >= 0)
        lane[first[pair.*side]++] = pair.lane;
    // each was moved on to where the next begins
    std::move_backward(first.begin(), first.end() - 1, first.end());
    first[0] = 0;
  }
};

/// The extremes over the contacts that act in a step.
struct Extremes {
  double overlap = 0.0;  ///< [L] deepest
  double spring = 0.0;   ///< [F] largest elastic normal force
  void include(double depth, double force) {
    overlap = depth > overlap ? depth : overlap;
    spring = force > spring ? force : spring;
  }
};

struct ActingLanes {
  ContactLanes lanes;
  std::vector<int> first_set;  ///< (windows + 1) in which its pairs have their lanes
  LanesOfBlocks lows, highs;   ///< lanes of which a block is the lower, the higher one
  Swing swing;                 ///< of the blocks since decisions began to be kept
  WorkSplit split;             ///< for the threads

  /// Calls tell(lane, is_low) for each lane that acts on block b, in the order of the
  /// list.
  template <class Tell> void each_lane_of(int b, const Tell& tell) const {
    for (int k = highs.first[b]; k < highs.first[b + 1]; ++k)
      tell(static_cast<unsigned>(highs.lane[k]), false);
    for (int k = lows.first[b]; k < lows.first[b + 1]; ++k)
      tell(static_cast<unsigned>(lows.lane[k]), true);
  }
};

inline BlockRows rows_of(const Blocks& blocks) {
  return {blocks.corner.data(), blocks.centroid.data(), blocks.velocity.data(),
          blocks.spin.data(), blocks.strain_rate.data()};
}

}  // namespace blocks::dynamics
