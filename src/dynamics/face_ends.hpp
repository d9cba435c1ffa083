// The ends of faces: the contacts at one end share its spring
// (docs/laws.md#length).
#pragma once

#include "dynamics/contacts/contact_arrays.hpp"

namespace blocks::dynamics {

/// Shares the springs of a batch at the ends of faces where a contact has begun or
/// ceased to act. Two corners may meet at an end, and each acts on the side of the
/// other. The force and the stiffness of the end are those of both contacts together.
/// If one acts, it carries them; if both act, each carries half. A contact that begins
/// to act takes the state of the law from the other one. A contact that an offset held
/// passes on what it held even if the other corner does not overlap. Only contacts with
/// stiffnesses of their own, or with offsets after INSITU, share, if both have the same
/// law and their edges are within 18 degrees of antiparallel. The spring of a
/// corner that slides goes on with it instead (spring_transfer.hpp). Call it when it is
/// settled which contacts act, before the forces are computed. A second call changes
/// nothing.
void share_ends(const Blocks& blocks, ContactArrays& arrays, int batch);

}  // namespace blocks::dynamics
