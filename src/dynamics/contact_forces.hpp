// Forces between blocks (FORD, report 2.5 and 3.3) and from symmetry planes (SPLANE).
#pragma once

#include <vector>

#include "dynamics/contact_groups.hpp"
#include "dynamics/profile.hpp"
#include "dynamics/workers.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Decides which potential contacts act (rules 9-12) and advances their springs (rule
/// 7). Reads corners, velocities and the blocks' swing; writes the groups' decisions
/// and lanes, from which sum_contacts takes what blocks feel.
Extremes evaluate_contacts(const Blocks& blocks, Contacts& contacts,
                           ContactGroups& groups, const Settings& settings, double dt,
                           Workers& workers, Profile* profile = nullptr);

/// Forces from symmetry planes, added to their blocks: frictionless, infinite mass, no
/// tension (rule 21).
Extremes add_plane_forces(Blocks& blocks, PlaneContacts& contacts,
                          const Settings& settings, double dt);

}  // namespace blocks::dynamics
