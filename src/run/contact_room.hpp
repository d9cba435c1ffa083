// Whether the list of contacts has room in the memory of this machine, asked before it
// is made.
#pragma once

#include "model/blocks.hpp"

namespace blocks::run {

/// What a list holds of blocks whose boxes overlap when they are extended by the margin
/// [L] >= 0: from a count for some of the blocks, up to 64.
struct LikelyList {
  double pairs = 0.0;  ///< of blocks
  double bytes = 0.0;
};
LikelyList likely_list(const Blocks& blocks, double margin);

/// Bytes of this machine's memory.
double physical_memory();

}  // namespace blocks::run
