// Which blocks a corner could have to do with, by a sweep over all corners: no boxes of
// the domain, no list of contacts, no memory of earlier steps.
#pragma once

#include <vector>

#include "model/blocks.hpp"

namespace blocks::audit {

/// For each corner (m) the other blocks whose bounding box, grown by `reach` [L] >= 0
/// and 6 % of its extents, holds it; in ascending order. Pairs of blocks that
/// are both fixed are left out: they have no contacts (rule 13).
std::vector<std::vector<int>> blocks_near_corners(const Blocks& blocks, double reach);

/// For each block the other blocks whose bounding boxes, grown by `reach` [L] >= 0 in
/// total, meet its own; in ascending order. Pairs of fixed blocks are left out.
std::vector<std::vector<int>> blocks_near_blocks(const Blocks& blocks, double reach);

}  // namespace blocks::audit
