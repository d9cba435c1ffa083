// External forces: symmetry planes, pressures on sides, forces at centroids, quiet
// sides and water (SPLANE, PRESSBC, FORCE, QUIET, WATER, JWATER). This is the fourth
// call of a step.
#pragma once

#include "dynamics/kernels/contact_batch.hpp"
#include "dynamics/support/workers.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns whether corners are listed near a symmetry plane, or the model has
/// loads of cards.
bool has_loads(const Model& model);

/// The two forces of a pressure, which act at the ends of its side.
struct PressureForces {
  Vec2 arm[2];    ///< [L] from the centroid
  Vec2 force[2];  ///< [F]
};
PressureForces forces_of(const Blocks& blocks, const Pressure& pressure, double factor);

/// Overwrites force and moment of all blocks with those of planes and of loads at
/// model.time. In deformable runs it also overwrites the sums f_i x_j. In rigid runs it
/// adds to them; they are meaningful only in a step that is read. A
/// pressure acts as the nodal loads L (2 p1 + p2) / 6 and L (p1 + 2 p2) / 6 at the
/// current corners. A force at a centroid adds nothing to moment and stress. shares:
/// splits the blocks among the workers. Returns the extremes of the contacts with
/// planes.
Extremes add_loads(Model& model, const std::vector<int>& shares, Workers& workers);

/// Adds the loads of the cards PRESSBC, FORCE and QUIET only.
void add_loads_of_cards(Model& model);

/// Returns the power of pressures and of forces at centroids at model.time, [F L/T].
double power_of_loads(const Model& model);

/// Adds the water on the blocks from begin to end at model.time.
void add_water(Model& model, int begin, int end);

}  // namespace blocks::dynamics
