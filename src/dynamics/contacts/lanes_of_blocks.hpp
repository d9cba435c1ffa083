// Which lanes act on each block.
#pragma once

#include <vector>

#include "dynamics/search/near_pairs.hpp"

namespace blocks::dynamics {

/// The lanes of the pairs of each block in which it is the lower one, or the higher
/// one, in the order of the pairs.
struct LanesOfBlocks {
  std::vector<int> first;  ///< (blocks + 1) where the lanes of a block begin
  std::vector<int> lane;

  /// side: &NearPair::low or &NearPair::high. lane_of_pair: -1 where a pair has none.
  void make(int blocks, const std::vector<NearPair>& pairs,
            const std::vector<int>& lane_of_pair, int NearPair::*side);
};

}  // namespace blocks::dynamics
