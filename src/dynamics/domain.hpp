// Fixes blocks that leave the domain (REBOX, report 3.1): the sixth call of a step.
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns whether every corner of block b is inside the domain or on its border.
bool is_inside_domain(const Blocks& blocks, int b, const Settings& settings);

/// Fixes every free or driven block that has a corner strictly outside the closed
/// domain, and records the block and the time. Returns the number of blocks fixed.
int fix_outside_domain(Model& model);

/// If `left_domain`, fixes the blocks that have left the domain. Subtracts `largest`,
/// the largest motion of a corner [L], from the distance that is left until the next
/// search.
void update_domain(Model& model, bool left_domain, double largest);

}  // namespace blocks::dynamics
