// Kinetic damping (KINDAMP, docs/rest.md#kinetic-damping): a model that has passed a
// peak of its kinetic energy is stopped.
#pragma once

#include <vector>

#include "dynamics/energy/energy_tally.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Sets the velocities, spins and strain rates of all free blocks to 0 if their kinetic
/// energy is less than before the last step. Call it in a step when the springs have
/// followed the last motion, before the blocks move. If it returns true, the blocks are
/// at rest at their present positions. Then forces must change the velocities for half
/// a step only (StepMotion::kick): with a whole one, fast modes would gain energy at
/// each stop. Updates Model::last_kinetic_energy. tallies: working memory.
bool stop_at_peak(Model& model, Workers& workers, std::vector<BlockTally>& tallies);

}  // namespace blocks::dynamics
