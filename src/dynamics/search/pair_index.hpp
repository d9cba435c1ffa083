// The near pairs of the last search, and which of them belong to each block.
#pragma once

#include <vector>

#include "dynamics/search/near_pairs.hpp"

namespace blocks::dynamics {

struct PairIndex {
  std::vector<NearPair> pairs;       ///< ordered by low, then by high
  std::vector<int> first_of_block;   ///< (blocks + 1) where the pairs of a block begin
  std::vector<int> pairs_of_blocks;  ///< indices of the pairs of each block
  std::vector<int> neighbours;       ///< the other block of each of these pairs

  int size() const { return static_cast<int>(pairs.size()); }
  /// Takes these pairs, which are ordered, of so many blocks. `found` gets the old
  /// ones.
  void take(std::vector<NearPair>& found, int blocks);

  /// Calls visit(block) for each block that block b is paired with, in the order of the
  /// pairs.
  template <class Visit> void each_neighbour(int b, const Visit& visit) const {
    for (int k = first_of_block[b]; k < first_of_block[b + 1]; ++k)
      visit(neighbours[k]);
  }
};

/// The neighbours of a block, as the contact rule asks for them.
struct Neighbours {
  const PairIndex& index;
  template <class Visit> void operator()(int block, const Visit& visit) const {
    index.each_neighbour(block, visit);
  }
};

}  // namespace blocks::dynamics
