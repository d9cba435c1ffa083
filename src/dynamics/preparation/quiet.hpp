// QUIET: makes sides quiet, and finds how fast their dashpots slow down a block
// (docs/waves.md#quiet-sides).
#pragma once

#include <vector>

#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns the largest rate at which dashpots slow down a motion of a free block,
/// [1/T]. A step of 2 over that rate is unstable, with or without other forces.
/// `sides` may have quiet sides of any blocks; only those of block b count.
double decay_rate(const Blocks& blocks, bool rigid, int b,
                  const std::vector<QuietSide>& sides);

/// Makes a side quiet. If it is quiet already, its wave speeds are replaced, and its
/// constant forces stay. A fixed or driven block becomes free. The force and moment
/// that held it are added to the constant forces of the side. A deformable block also
/// gets the stress that is in equilibrium with the forces on it. Forces and stresses
/// are those of the last step. Returns the force that held the block, [F], and 0 for a
/// free block. The block must be inside the domain and not removed.
Vec2 make_quiet(Model& model, const QuietSide& quiet);

}  // namespace blocks::dynamics
