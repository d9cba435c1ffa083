// Which pairs of blocks may touch: the first call of a step.
#pragma once

#include <vector>

#include "dynamics/workspace.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Searches again if corners may have moved as far as search.left, or if the springs
/// are in the list: finds the pairs of blocks that may touch until then, makes the
/// arrays for them, and forgets all decisions. Contacts keep their springs; a pair
/// whose contacts have springs stays, near or not, because these may need successors.
/// The pairs `also`, which are ordered, are added. Reads blocks and, if it owns the
/// springs, the list; writes search, plane contacts, pairs and arrays.
void update_pairs(Model& model, Workspace& work,
                  const std::vector<NearPair>& also = {});

}  // namespace blocks::dynamics
