// Pressures on sides and forces at centroids (PRESS, FORCE; rule 23).
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Adds all loads at `time` to force, moment and f_i x_j of their blocks. A pressure
/// acts as the nodal loads L (2 p1 + p2) / 6 and L (p1 + 2 p2) / 6 at the current
/// corners; a centroid force contributes nothing to moment and stress.
void add_loads(Blocks& blocks, const Loads& loads, double time);

}  // namespace blocks::dynamics
