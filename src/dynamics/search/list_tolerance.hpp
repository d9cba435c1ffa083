// The distance that corners may move between two searches for near pairs (CTOL, report
// 3.2).
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns how far corners may move before near pairs have to be found again, [L]. It
/// is the distance that a block with the largest speed and spin moves in 250 steps. It
/// is at most a tenth of the block size, but at least CTOL. For more than 131,072
/// blocks it is CTOL. A longer distance makes searches rarer and each step more
/// expensive.
double list_tolerance(const Model& model);

}  // namespace blocks::dynamics
