// Which blocks are near enough to touch before the next search (UPDAT, report 3.2).
#pragma once

#include <compare>
#include <vector>

#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Two blocks, low < high, at least one of them free.
struct NearPair {
  int low = 0, high = 0;
  int lane = -1;  ///< of its contacts (PairContacts); -1: it has had none
  auto operator<=>(const NearPair& other) const = default;
  /// The one that is not this block.
  int beside(int block) const { return low == block ? high : low; }
};

/// Working memory of the search, kept between searches.
struct NearSearch {
  std::vector<Vec2> lower, upper;   ///< (blocks) [L] of their grown boxes
  std::vector<int> first, in_cell;  ///< cells and the blocks in them
};

/// All pairs whose boxes meet, each grown by `reach`, [L], ordered by low and high: no
/// other blocks can touch before a corner has moved by that much.
void find_near_pairs(const Blocks& blocks, double reach, NearSearch& memory,
                     std::vector<NearPair>& pairs);

}  // namespace blocks::dynamics
