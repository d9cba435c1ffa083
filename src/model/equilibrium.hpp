// How far a model is from equilibrium (docs/rest.md#the-ratio).
#pragma once

#include "model/model.hpp"

namespace blocks {

/// Returns the time at which the last step evaluated gravity and loads, [T].
double time_of_forces(const Model& model);

/// Returns the unbalanced force of block b in the last step, [F]: |F| + |T| / g. F is
/// the resultant of contacts, loads and gravity, T their moment, and g = sqrt(inertia /
/// mass) the radius of gyration. A deformable block has in addition
/// A |applied - internal stress| / g. The block of a servo has what its side lacks of
/// the force that the servo shall hold. Returns 0 for other blocks that are not free.
double unbalanced_force(const Model& model, int b);

/// Sets forces[b] to the unbalanced force of each block, (n).
void unbalanced_forces(const Model& model, Eigen::VectorXd& forces);

/// Returns whether damping that is meant for statics acts: LOCDAMP or KINDAMP.
bool is_damped_to_rest(const Settings& settings);

/// Returns the ratio of the sum of all unbalanced forces to the sum of all forces:
/// those of contacts, symmetry planes, loads and servos, and the weights of free
/// blocks. It is 0 in equilibrium and 1 for blocks that fall freely. It may exceed 1 if
/// the stress of blocks does not fit the forces on them. Returns 0 if there are no
/// forces. Forces of contacts must be known: the last step had readings
/// (dynamics::advance).
double unbalanced_ratio(const Model& model);

/// Returns whether gravity or a load will still change: within a ramp of gravity, or
/// before a load has arrived or its time function has reached its last value.
bool loads_will_change(const Model& model);

}  // namespace blocks
