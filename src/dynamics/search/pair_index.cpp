#include "dynamics/search/pair_index.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace blocks::dynamics {

void PairIndex::take(std::vector<NearPair>& found, int blocks) {
  pairs.swap(found);
  std::vector<int>& first = first_of_block;
  first.assign(static_cast<std::size_t>(blocks) + 1, 0);
  for (const NearPair& pair : pairs)
    ++first[pair.low + 1], ++first[pair.high + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  pairs_of_blocks.resize(static_cast<std::size_t>(first.back()));
  neighbours.resize(static_cast<std::size_t>(first.back()));
  for (int p = 0; p < size(); ++p)
    for (const int b : {pairs[p].low, pairs[p].high}) {
      pairs_of_blocks[first[b]] = p;
      neighbours[first[b]++] = pairs[p].other(b);
    }
  // Each entry has advanced to the beginning of the next one.
  std::move_backward(first.begin(), first.end() - 1, first.end());
  first[0] = 0;
}

}  // namespace blocks::dynamics
