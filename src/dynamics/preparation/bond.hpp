// BOND: makes the faces of flush blocks bonded and intact (docs/laws.md#cards).
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Bonds the contacts at both ends of every face whose two sides are at most
/// `tolerance` [L] apart there, and whose contacts have the law of joint `id` (0: any
/// law of a joint, except Barton's, which has no bond). Bonded contacts are listed in
/// the model: they act from the next step on, without force at first. Contacts that
/// exist already keep their springs. Returns the number of bonded contacts.
int bond_faces(Model& model, int id, double tolerance);

}  // namespace blocks::dynamics
