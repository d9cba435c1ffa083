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
};

/// Calls a visitor for each neighbour of a block, in the form that the contact rule
/// needs.
struct Neighbours {
  const PairIndex& index;
  template <class Visit> void operator()(int block, const Visit& visit) const {
    index.neighbours.each(block, visit);
  }
};

}  // namespace blocks::dynamics
