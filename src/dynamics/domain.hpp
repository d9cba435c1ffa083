// Blocks that leave the domain become fixed (REBOX, report 3.1, rule 14).
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Fixes every free block with a corner strictly outside the closed domain, where it
/// stands, and records block and time. Returns how many.
int fix_outside_domain(Model& model);

}  // namespace blocks::dynamics
