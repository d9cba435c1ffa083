// The table of `blocks run --profile`.
#pragma once

#include <string>
#include <vector>

#include "dynamics/support/profile.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Returns the lines of the table for a run of `seconds` and `steps`. It lists the
/// seconds and share of each phase, how much of a call of the step is serial, the cost
/// per block and step, and the number of exact predicate evaluations.
std::vector<std::string> profile_table(const dynamics::Profile& profile, double seconds,
                                       long steps, const Model& model, int threads);

}  // namespace blocks::run
