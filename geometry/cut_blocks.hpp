// Makes blocks of certified cells: T vertices are dropped from the block in whose side
// they are. Part of cut.cpp.
#pragma once

#include <vector>

#include "geometry/cut.hpp"

namespace blocks::geometry {

/// For each cell and each of its vertices, whether both edges there are on one line
/// before rounding, with one joint id.
using StraightCorners = std::vector<std::vector<bool>>;

/// Fills `blocks` and the certificate of the result. The tiling is certified after all
/// vertices have moved; if it does not hold then, no vertex moves. A T vertex that
/// rounding has put inside the block with the straight side is moved out by a few units
/// in the last place of the largest coordinate. What cannot be moved so remains a
/// corner of that block. Guarantees: each block is a part of its cell, so blocks share
/// no interior point if the cells of the final mesh are certified.
void make_blocks(CutResult& result, const StraightCorners& straight,
                 StepProgress progress);

/// Counts the sides of the blocks that are shorter than emin, [L]. A common side counts
/// once.
std::size_t short_sides(const CutResult& result, double emin);

}  // namespace blocks::geometry
