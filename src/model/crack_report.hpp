// Tells which blocks may split, and what limits the time step, for the listing and for
// `check` (docs/cracks.md).
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks {

/// Returns the rule in words: "stress" or "point loads".
const char* describe(CrackCause cause);

/// Returns a line for each CRACK and MDAMP card in force. Empty without them.
std::string crack_report(const Settings& settings);

/// Returns what limits the time step, in words: "contact", "its stiffness", or "the
/// stiffness of a piece of it" if a crack may make that piece. `elasticity` is the word
/// for the limit by the deformation of the block.
std::string limit_in_words(const TimeStep& step,
                           const std::string& elasticity = "stiffness");

}  // namespace blocks
