// Finds blocks that are near each other by a sweep over all blocks. It uses no grid, no
// list of pairs and nothing from earlier steps.
#pragma once

#include <vector>

#include "model/blocks.hpp"

namespace blocks::audit {

/// Returns for each block the other blocks whose bounding boxes meet its own when they
/// are grown by `reach` [L] >= 0 in total. They are in ascending order. Pairs of fixed
/// blocks and removed blocks are left out, because they have no contacts.
std::vector<std::vector<int>> blocks_near_blocks(const Blocks& blocks, double reach);

}  // namespace blocks::audit
