// Splits the blocks whose strength a step has reached (CRACK, docs/cracks.md). Called
// between two steps.
#pragma once

#include <functional>
#include <vector>

#include "dynamics/workspace.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns whether blocks may split.
inline bool may_crack(const Settings& settings) {
  return !settings.crack_rules.empty();
}

/// Returns whether the rules need the contact forces of every step: those of rigid
/// blocks and of point loads.
bool needs_contact_forces(const Settings& settings);

/// Splits each free block that reaches a strength, once. Blocks split in the order of
/// their numbers; new blocks get the next numbers. Records cracks and refusals in the
/// model, and the released energy in its energy account. Call it after a step; if
/// needs_contact_forces(), the step must have been read. numbers: (n) the number of
/// each block in the deck; empty: its own. before_split: called before blocks are
/// replaced, if there are cracks; may be empty. Returns the number of cracks; if there
/// are any, the list of contacts is up to date.
int crack_blocks(Model& model, Workspace& work, const std::vector<int>& numbers,
                 const std::function<void()>& before_split = {});

}  // namespace blocks::dynamics
