// Forces from outside: symmetry planes, pressures on sides and forces at centroids
// (SPLANE, PRESS, FORCE): the fourth call of a step.
#pragma once

#include "dynamics/kernels/contact_batch.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Whether anything but contacts may act on blocks.
bool has_loads(const Model& model);

/// Overwrites force and moment of all blocks, in deformable runs also the sums f_i x_j,
/// with those of planes and of loads at model.time; in rigid runs f_i x_j are added. A
/// pressure acts as the nodal loads L (2 p1 + p2) / 6 and L (p1 + 2 p2) / 6 at the
/// current corners; a centroid force contributes nothing to moment and stress. Returns
/// the extremes of the contacts with planes.
Extremes add_loads(Model& model);

}  // namespace blocks::dynamics
