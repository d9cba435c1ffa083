// What the two pieces of a block take with them: mass, momentum and stress
// (docs/cracks.md#what-a-piece-takes-with-it).
#pragma once

#include "geometry/split.hpp"
#include "model/splitting.hpp"

namespace blocks::dynamics {

/// Returns the pieces of block b with their masses, velocities and stresses. The larger
/// piece is the first one; of equal ones, that with the first corner of the block.
/// Their momentum and angular momentum are those of the block, except for rounding. The
/// stress at right angles to the chord becomes 0 if it is tensile. cut: without fault.
BlockSplit pieces_of(const Blocks& blocks, int b, geometry::Split cut);

}  // namespace blocks::dynamics
