// Whether the list of contacts has room in the memory of this machine, asked before it
// is made.
#pragma once

#include "model/blocks.hpp"

namespace blocks::run {

/// How many pairs of blocks have boxes that overlap when they are extended by the
/// margin [L] >= 0: those a list holds. Counted for some of the blocks, up to 64.
double likely_pairs(const Blocks& blocks, double margin);

/// That many fit into the memory of this machine.
double pairs_in_memory();

}  // namespace blocks::run
