// Which pieces come from the same block.
#pragma once

#include <vector>

#include "draw/colour_map.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

/// The colour of blocks that have not split, in figures of families.
constexpr draw::Colour whole_colour{0.88, 0.88, 0.87};

/// Returns, for each piece in a frame, the number of the deck's block that it came
/// from, from 1. Blocks that have not split have 0.
std::vector<int> families_of(const Frame& frame);

}  // namespace blocks::post
