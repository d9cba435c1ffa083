// Finds pairs of blocks that may touch before the next search (UPDAT, report 3.2).
#pragma once

#include <compare>
#include <vector>

#include "dynamics/support/groups.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Two blocks, low < high, at least one of them free or driven.
struct NearPair {
  int low = 0, high = 0;
  auto operator<=>(const NearPair& other) const = default;
};

/// Working memory of the search. It is kept between searches so that they need not
/// allocate.
struct NearSearch {
  /// (blocks) [L] corners of their grown bounding boxes
  std::vector<Vec2> lower, upper;
  Groups cells;  ///< the blocks in each cell of a grid
};

/// Finds all pairs whose bounding boxes meet when each box is grown by `reach`, [L], by
/// the slack of its edges and by the reach of third parts. The pairs are sorted by low,
/// then by high. No other two blocks can touch before a corner has moved by `reach`.
void find_near_pairs(const Blocks& blocks, double reach, NearSearch& memory,
                     std::vector<NearPair>& pairs);

}  // namespace blocks::dynamics
