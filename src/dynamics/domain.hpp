// Blocks that leave the domain become fixed (REBOX, report 3.1): the sixth call of a
// step.
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Whether no corner of block b is outside the closed domain.
bool is_inside_domain(const Blocks& blocks, int b, const Settings& settings);

/// Fixes every free block with a corner strictly outside the closed domain where it is,
/// and records block and time. Returns how many.
int fix_outside_domain(Model& model);

/// Fixes blocks that have left the domain, if some corner has. Takes the largest motion
/// of a corner, [L], off the distance that is left until the next search.
void update_domain(Model& model, bool left_domain, double largest);

}  // namespace blocks::dynamics
