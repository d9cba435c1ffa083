// The tables of a sweep of the study of contact detection. They are those that
// `blocks study contacts` makes of the same frames.
#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"
#include "sweep/plan.hpp"

namespace blocks::sweep {

/// Returns a study for each scene of the plan, in its order, from the outcomes in the
/// folder. A frame whose scene could not be made refuses the scene, and likewise a
/// variant. Throws files::FileError if the plan is not that of a study, or if a run
/// has no outcome, a damaged one, or another error.
std::vector<study::Study> read_studies(const std::string& folder, const Plan& plan);

}  // namespace blocks::sweep
