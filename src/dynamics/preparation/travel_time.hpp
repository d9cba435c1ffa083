// How long a push takes through the blocks of a model. Blocks that slide together swing
// no slower than this allows.
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns the longest time that a push needs from one free block to another along
/// blocks that touch, [T]. From block to block it needs sqrt(m / K): m is the mean of
/// their inertial masses, and K the normal stiffness of their contacts that act or, if
/// none does, that of their corners within ctol, in series with that of deformable
/// blocks. A row of n such blocks between a fixed and a free end swings with the period
/// 4 n sqrt(m / K).
double longest_travel_time(const Model& model);

}  // namespace blocks::dynamics
