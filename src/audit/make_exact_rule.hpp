// Prepares the exact contact rule for blocks as they are.
#pragma once

#include <vector>

#include "audit/exact_pair_rule.hpp"

namespace blocks::audit {

/// The convex parts of all blocks: the blocks themselves, or what they were cut into
/// when they were made (Blocks::cuts).
std::vector<ConvexPart> cut_into_parts(const Blocks& blocks);

/// The exact rule for these blocks. Its neighbours are all blocks whose bounding boxes,
/// grown by `reach` [L], meet and of which one is free. They need no list: a side that
/// covers lies in part in the block that asks, so any larger set has the same effect.
/// `order` is that of ExactPairRule.
ExactPairRule make_exact_rule(const Blocks& blocks, double reach,
                              const std::vector<int>& order = {});

}  // namespace blocks::audit
