// What becomes of the spring of a contact that has ceased to act
// (docs/theory.md#hand-over-of-springs).
#pragma once

#include "dynamics/pair_contacts.hpp"

namespace blocks::dynamics {

/// Each lost spring goes to the acting contact that can take most of it: of the same
/// corner, or of the same two blocks if the force keeps its direction. `heirs` become
/// the sets whose contacts were handed some.
void transfer_springs(const Blocks& blocks, PairContacts& all, double normal_stiffness);

}  // namespace blocks::dynamics
