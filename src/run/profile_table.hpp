// The table of `blocks run --profile`.
#pragma once

#include <string>
#include <vector>

#include "dynamics/support/profile.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// Line by line: seconds and share of each phase of a run of so many seconds and steps,
/// the cost of a block and step, and how often exact arithmetic was asked.
std::vector<std::string> profile_table(const dynamics::Profile& profile, double seconds,
                                       long steps, const Model& model, int threads);

}  // namespace blocks::run
