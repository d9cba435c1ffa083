// Checks the loads in a checkpoint, water among them. Part of
// checkpoint_validation.cpp.
#pragma once

#include "model/model.hpp"

namespace blocks::output {

/// Expects loads on sides and blocks that exist, and water that cards can make. Throws
/// like validate_checkpoint().
void expect_loads(const Loads& loads, const Blocks& b);

}  // namespace blocks::output
