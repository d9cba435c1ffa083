// Creates the exact contact rule for blocks in their current state.
#pragma once

#include <vector>

#include "audit/exact_pair_rule.hpp"

namespace blocks::audit {

/// Returns the convex parts of all blocks. A convex block is one part; another block
/// has the parts into which it was cut when it was made (Blocks::cuts).
std::vector<ConvexPart> cut_into_parts(const Blocks& blocks);

/// Returns the exact rule for these blocks. Two blocks are neighbours if their bounding
/// boxes, grown by the reach of third parts, are at most `reach` [L] apart and one of
/// the two is free. This needs no list of near pairs. `order`: see ExactPairRule.
ExactPairRule make_exact_rule(const Blocks& blocks, double reach,
                              const std::vector<int>& order = {});

}  // namespace blocks::audit
