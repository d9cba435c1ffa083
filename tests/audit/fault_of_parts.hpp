// Tests whether the convex parts of a block tile it.
#pragma once

#include <string>
#include <vector>

#include "audit/exact_parts.hpp"
#include "model/blocks.hpp"

namespace blocks::audit {

/// Returns a sentence that says why these parts do not tile the block, or an empty
/// string if they do. The parts tile it if they are convex, have only corners of the
/// block, do not overlap and leave no gap. Parts without area may be missing.
std::string fault_of_parts(const Blocks& blocks, int block,
                           const std::vector<ConvexPart>& parts);

}  // namespace blocks::audit
