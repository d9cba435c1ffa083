// Finds the pairs of blocks that may touch: the first call of a step.
#pragma once

#include "dynamics/workspace.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Searches again, with a new tolerance, if search.current is false: corners may have
/// moved by the whole of search.left, or blocks, planes or fixities have changed. Also
/// lists the pairs again, within what is left, if only the list of contacts holds the
/// current springs. A search finds the pairs of blocks that may touch before the next
/// one and makes the arrays for them. It keeps the decisions that new neighbours cannot
/// change, unless the list of contacts holds the current springs. Contacts keep their
/// springs. A pair whose contacts have springs stays in the list even if it
/// is not near, because its springs may pass to successors. Reads blocks and, if it owns
/// the springs, the list of contacts. Writes search, plane contacts, pairs and arrays.
void update_pairs(Model& model, Workspace& work);

}  // namespace blocks::dynamics
