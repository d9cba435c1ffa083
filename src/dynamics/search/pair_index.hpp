// The near pairs of the last search, and the neighbours of each block.
#pragma once

#include <vector>

#include "dynamics/search/near_pairs.hpp"
#include "dynamics/support/groups.hpp"

namespace blocks::dynamics {

struct PairIndex {
  std::vector<NearPair> pairs;  ///< sorted by low, then by high
  Groups neighbours;  ///< for each block, the blocks that it is paired with, ascending

  int size() const { return static_cast<int>(pairs.size()); }
  /// Replaces the pairs by those of `found`, which must be sorted. `blocks` is the
  /// number of blocks. `found` gets the former pairs.
  void take(std::vector<NearPair>& found, int blocks) {
    pairs.swap(found);
    neighbours.sort(blocks, [&](const auto& add) {
      for (const NearPair& pair : pairs)
        add(pair.low, pair.high), add(pair.high, pair.low);
    });
  }
  /// Calls visit(block) for each other block that is paired with both blocks of a pair
  /// or, if `with_one`, with at least one of them, in ascending order.
  template <class Visit>
  void each_beside(const NearPair& pair, bool with_one, const Visit& visit) const {
    const auto list = [&](int block) {
      return neighbours.item.begin() + neighbours.first[block];
    };
    auto low = list(pair.low), high = list(pair.high);
    const auto end_low = list(pair.low + 1), end_high = list(pair.high + 1);
    while (low != end_low || high != end_high) {
      const bool of_low = high == end_high || (low != end_low && *low <= *high),
                 of_high = low == end_low || (high != end_high && *high <= *low);
      const int block = of_low ? *low : *high;
      if ((with_one || (of_low && of_high)) && block != pair.low && block != pair.high)
        visit(block);
      low += of_low, high += of_high;
    }
  }
};

}  // namespace blocks::dynamics
