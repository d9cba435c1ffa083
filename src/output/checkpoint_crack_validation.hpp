// Checks the rules and records of cracks in a checkpoint. Part of
// checkpoint_validation.cpp.
#pragma once

#include "model/model.hpp"

namespace blocks::output {

/// Expects valid rules and records of cracks. Throws like validate_checkpoint().
void expect_cracks(const Model& model);

}  // namespace blocks::output
