// Tells which law acts between which blocks, for the listing and for `check`
// (docs/laws.md).
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks {

/// Returns lines on the law of each joint id, where it acts, and the driven blocks.
/// Empty if the model has neither laws nor driven blocks.
std::string law_report(const Model& model);

/// Returns one line on the contacts with a law: how many are bonded, have failed, and
/// have broken since BOND.
std::string bonds_line(const Model& model);

}  // namespace blocks
