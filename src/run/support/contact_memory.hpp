// Estimates, before the contact list is made, whether it fits into the memory of this
// machine.
#pragma once

#include "model/blocks.hpp"

namespace blocks::run {

/// The estimated size of the contact list. It lists pairs of blocks whose bounding
/// boxes overlap when one is extended by the margin [L] >= 0. The estimate samples at
/// most 64 blocks.
struct LikelyList {
  double pairs = 0.0;  ///< number of pairs of blocks
  double bytes = 0.0;
};
LikelyList likely_list(const Blocks& blocks, double margin);

/// The physical memory of this machine, in bytes.
double physical_memory();

}  // namespace blocks::run
