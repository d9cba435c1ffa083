// Tells which blocks may split, for the listing and for `check` (docs/cracks.md).
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks {

/// Returns the rule in words: "stress" or "point loads".
const char* describe(CrackCause cause);

/// Returns a line for each CRACK and MDAMP card in force. Empty without them.
std::string crack_report(const Settings& settings);

}  // namespace blocks
