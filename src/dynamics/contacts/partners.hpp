// Partners: the second contacts at the ends of faces. After INSITU they can take over
// the springs of the first ones (docs/rest.md#stress-in-the-ground).
#pragma once

#include <vector>

#include "dynamics/contacts/pair_contacts.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Adds the partners of the contacts of a pair. A face is a
/// pair of sides of two blocks within 18 degrees of antiparallel (cosine of at least
/// 0.95). Two contacts are possible at each end of it: a corner of either block on the
/// side of the other. Let a given contact have corner c and edge e, and let s be a side
/// that begins or ends at c. If e and s are a face, the contact at the same end is
/// added: that of a corner of e on s. Added contacts do not act before they receive
/// springs. `contacts` are in ascending order of corner and edge.
void add_partners(const Blocks& blocks, std::vector<PairContact>& contacts);

}  // namespace blocks::dynamics
