// What becomes of a spring when another edge or corner takes its place. Not in the
// report: docs/departures.md.
#pragma once

#include "dynamics/contact_groups.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Gives the elastic forces lost in this step to the contacts that took their place, so
/// that a block does not sink anew whenever its corner crosses a joint, or whenever of
/// two corners beside each other now the one, now the other is inside. Heirs are acting
/// records of the same corner, and of other corners of the same two blocks whose edge
/// is within 18 degrees of parallel. The one that can take most takes it: the energies
/// FN^2 / 2 Kn of the springs add up, and no spring becomes stronger than its overlap
/// explains, so that energy never grows. Shear is taken by its component along the new
/// edge. Forgets the lost forces. To the springs at the start of the step: the sets of
/// the heirs have to act again.
void hand_over(const Blocks& blocks, const Contacts& contacts, ContactGroups& groups,
               double normal_stiffness);

}  // namespace blocks::dynamics
