// How far ahead a search looks for contacts (CTOL, report 3.2).
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns how far corners may move before near pairs have to be found again, [L]:
/// CTOL, or as far as the fastest block moves in 250 steps, but at most a tenth of the
/// block size. A longer distance makes searches rarer and each step more expensive.
double list_tolerance(const Model& model);

}  // namespace blocks::dynamics
