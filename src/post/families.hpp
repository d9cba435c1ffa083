// Which pieces come from the same block.
#pragma once

#include <vector>

#include "post/colour_map.hpp"
#include "post/results_reader.hpp"

namespace blocks::post {

/// The colour of blocks that have not split, in figures of families.
constexpr Colour whole_colour{0.88, 0.88, 0.87};

/// Returns for each block of a frame the number of the block of the deck of which it is
/// a piece, from 1; 0 for blocks that have not split.
std::vector<int> families_of(const Frame& frame);

}  // namespace blocks::post
