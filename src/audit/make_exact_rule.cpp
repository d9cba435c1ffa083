#include "audit/make_exact_rule.hpp"

#include <algorithm>

#include "audit/neighbours.hpp"

namespace blocks::audit {

std::vector<ConvexPart> cut_into_parts(const Blocks& blocks) {
  std::vector<ConvexPart> parts;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.convex[b])
      continue;
    parts.push_back({b, {}});
    for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
      parts.back().corners.push_back(c);
  }
  blocks.each_cut([&](int b, auto cut) {
    parts.push_back({b, {}});
    for (const int c : cut)
      parts.back().corners.push_back(blocks.first_corner[b] + c);
  });
  std::stable_sort(
      parts.begin(), parts.end(),
      [](const ConvexPart& l, const ConvexPart& r) { return l.block < r.block; });
  return parts;
}

ExactPairRule make_exact_rule(const Blocks& blocks, double reach,
                              const std::vector<int>& order) {
  return {blocks, cut_into_parts(blocks), blocks_near_blocks(blocks, reach), order};
}

}  // namespace blocks::audit
