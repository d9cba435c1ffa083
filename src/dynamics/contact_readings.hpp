// What only readers of the model want of a step: forces and overlaps of its contacts,
// applied stress of rigid blocks.
#pragma once

#include "dynamics/contact_groups.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Makes `contacts` tell what acts in the step whose contacts have just been evaluated,
/// springs as they are at its end; gives rigid blocks the sums f_i x_j of (9). Before
/// anything moves. What moves the blocks stays the same, bit by bit.
void read_contacts(Blocks& blocks, Contacts& contacts, ContactGroups& groups,
                   const Settings& settings, double dt);

}  // namespace blocks::dynamics
