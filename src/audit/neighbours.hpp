// Which blocks are near each other, by a sweep over all blocks: no grid, no list of
// pairs, no memory of earlier steps.
#pragma once

#include <vector>

#include "model/blocks.hpp"

namespace blocks::audit {

/// For each block the other blocks whose bounding boxes, grown by `reach` [L] >= 0 in
/// total, meet its own; in ascending order. Pairs of fixed blocks are left out, because
/// they have no contacts.
std::vector<std::vector<int>> blocks_near_blocks(const Blocks& blocks, double reach);

}  // namespace blocks::audit
