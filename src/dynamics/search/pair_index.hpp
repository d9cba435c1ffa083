// The near pairs of the last search, and the neighbours of each block.
#pragma once

#include <vector>

#include "dynamics/search/near_pairs.hpp"
#include "dynamics/support/groups.hpp"

namespace blocks::dynamics {

struct PairIndex {
  std::vector<NearPair> pairs;  ///< ordered by low, then by high
  Groups neighbours;  ///< the blocks that each block is paired with, in their order

  int size() const { return static_cast<int>(pairs.size()); }
  /// Takes these pairs, which are ordered, of so many blocks. `found` gets the old
  /// ones.
  void take(std::vector<NearPair>& found, int blocks) {
    pairs.swap(found);
    neighbours.sort(blocks, [&](const auto& add) {
      for (const NearPair& pair : pairs)
        add(pair.low, pair.high), add(pair.high, pair.low);
    });
  }
};

/// The neighbours of a block, as the contact rule asks for them.
struct Neighbours {
  const PairIndex& index;
  template <class Visit> void operator()(int block, const Visit& visit) const {
    index.neighbours.each(block, visit);
  }
};

}  // namespace blocks::dynamics
