#include "dynamics/contacts/lanes_of_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace blocks::dynamics {

void LanesOfBlocks::make(int blocks, const std::vector<NearPair>& pairs,
                         const std::vector<int>& lane_of_pair, int NearPair::*side) {
  first.assign(static_cast<std::size_t>(blocks) + 1, 0);
  for (std::size_t p = 0; p < pairs.size(); ++p)
    first[pairs[p].*side + 1] += lane_of_pair[p] >= 0;
  std::partial_sum(first.begin(), first.end(), first.begin());
  lane.resize(static_cast<std::size_t>(first.back()));
  for (std::size_t p = 0; p < pairs.size(); ++p)
    if (lane_of_pair[p] >= 0)
      lane[first[pairs[p].*side]++] = lane_of_pair[p];
  // Each entry has advanced to the beginning of the next one.
  std::move_backward(first.begin(), first.end() - 1, first.end());
  first[0] = 0;
}

}  // namespace blocks::dynamics
