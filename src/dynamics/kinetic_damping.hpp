// Kinetic damping (KINDAMP, docs/rest.md#kinetic-damping): a model that has passed a
// peak of its kinetic energy is stopped.
#pragma once

#include <vector>

#include "dynamics/energy_tally.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Sets the velocities, spins and strain rates of all free blocks to 0 if their kinetic
/// energy is less than before the last step. Call it in a step before blocks move: the
/// springs have followed the motion, so nothing of it is lost. Updates
/// Model::kinetic_energy. Returns whether the blocks were stopped. tallies, shares:
/// working memory.
bool stop_at_peak(Model& model, const WorkSplit& split, Workers& workers,
                  std::vector<BlockTally>& tallies, std::vector<int>& shares);

}  // namespace blocks::dynamics
