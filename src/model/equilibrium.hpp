// How far a model is from equilibrium (docs/rest.md#the-ratio).
#pragma once

#include "model/model.hpp"

namespace blocks {

/// Returns the time at which the last step evaluated gravity and loads, [T].
double time_of_forces(const Model& model);

/// Returns the unbalanced force of block b in the last step, [F]: |F| + |T| / g, where
/// F is the resultant of contacts, loads and gravity, T their moment, and g =
/// sqrt(inertia / mass) the radius of gyration. A deformable block has in addition
/// |A (applied - internal stress)| / g. Returns 0 for blocks that are not free.
double unbalanced_force(const Model& model, int b);

/// Sets forces[b] to the unbalanced force of each block, (n).
void unbalanced_forces(const Model& model, Eigen::VectorXd& forces);

/// Whether damping that is meant for statics acts: LOCDAMP or KINDAMP.
bool is_damped_to_rest(const Settings& settings);

/// Returns the ratio of the unbalanced forces of all free blocks to all forces that act
/// on blocks: those of contacts, symmetry planes and loads, and the weights of free
/// blocks. It is 0 in equilibrium and 1 for blocks that fall freely. 0 if there are no
/// forces. The model must have been read after a step (dynamics::advance with
/// readings).
double unbalanced_ratio(const Model& model);

}  // namespace blocks
