#include "exchange/block_record.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace blocks::exchange {

// {fmt} and std::to_chars give the shortest digits. "-0" keeps its sign, because the
// readers here read the digits as written.
std::string shortest(double value) { return fmt::format("{}", value); }

bool has_joints(const std::vector<BlockRecord>& blocks) {
  return std::any_of(blocks.begin(), blocks.end(), [](const BlockRecord& block) {
    return std::any_of(block.joints.begin(), block.joints.end(),
                       [](int joint) { return joint != 0; });
  });
}

std::vector<RingPosition> closed_ring(const BlockRecord& block) {
  const std::size_t n = block.outline.size();
  std::vector<RingPosition> ring;
  for (std::size_t i = 0; i <= n; ++i)
    ring.push_back({block.outline[(n - i) % n],
                    block.joints.empty() ? 0 : block.joints[n - 1 - i % n]});
  return ring;
}

}  // namespace blocks::exchange
