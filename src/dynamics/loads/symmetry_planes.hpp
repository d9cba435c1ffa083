// Symmetry planes (SPLANE, report 2.5): the corners that may touch them, and the forces
// of these contacts.
#pragma once

#include "dynamics/kernels/contact_batch.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Finds the corners of free blocks that may touch a plane before a corner has moved by
/// `tolerance`, [L]. Contacts that were listed before keep their springs. `memory` is
/// working memory, kept between calls.
void update_plane_contacts(Model& model, std::vector<PlaneContact>& memory,
                           double tolerance);

/// What a plane does to a corner in a step.
struct PlaneForce {
  bool acts = false;           ///< the corner is behind the plane, or held by INSITU
  Vec2 inward = Vec2::Zero();  ///< unit normal of the plane, towards the blocks
  Vec2 arm = Vec2::Zero();     ///< [L] from the centroid of the block to the plane
  double overlap = 0.0;        ///< [L] >= 0
  double closing = 0.0;        ///< [L/T] velocity of the corner into the plane
  double lag = 0.0;            ///< [L/T] closing of half a step before, less closing
  double spring = 0.0;         ///< [F] at the end of the step
  double normal = 0.0;         ///< [F] spring and dashpot
};

/// Computes the force of a contact from its spring at the start of the step. If the
/// contact does not act, all values are 0.
PlaneForce plane_force(const Blocks& blocks, const PlaneContact& contact,
                       const Settings& settings, double dt);

/// Advances the springs of the planes by a step, and adds their forces to the blocks. A
/// plane is frictionless, has infinite mass and carries no tension. Returns the largest
/// overlap and spring.
Extremes add_plane_forces(Model& model);

}  // namespace blocks::dynamics
