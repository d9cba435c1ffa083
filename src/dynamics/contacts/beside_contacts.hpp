// The contacts at the same ends of faces as other ones, which can take over their
// springs after INSITU (docs/rest.md#stress-in-the-ground).
#pragma once

#include <vector>

#include "dynamics/contacts/pair_contacts.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Adds to the contacts of a pair, which are in ascending order of corner and edge, the
/// contacts at the same ends of their faces. The added ones do not act by themselves.
/// `given`: working memory.
void add_beside(const Blocks& blocks, std::vector<PairContact>& contacts,
                std::vector<PairContact>& given);

}  // namespace blocks::dynamics
