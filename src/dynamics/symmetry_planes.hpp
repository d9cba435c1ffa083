// Symmetry planes (SPLANE, report 2.5): the corners that may touch them, and the forces
// of these contacts.
#pragma once

#include "dynamics/kernels/contact_batch.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Finds the corners of free blocks that may touch a plane before a corner has moved by
/// `tolerance`, [L]. Contacts that were listed before keep their springs. `memory` is
/// working memory, kept between calls.
void update_plane_contacts(Model& model, PlaneContacts& memory, double tolerance);

/// Adds the forces of the planes to the blocks. A plane is frictionless, has infinite
/// mass and carries no tension. Returns the largest overlap and spring.
Extremes add_plane_forces(Blocks& blocks, PlaneContacts& contacts,
                          const Settings& settings, double dt);

}  // namespace blocks::dynamics
