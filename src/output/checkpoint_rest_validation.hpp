// Checks the results of SOLVE and FOS cards in a checkpoint. Part of
// checkpoint_validation.cpp.
#pragma once

#include "model/model.hpp"

namespace blocks::output {

/// Expects valid results of SOLVE and FOS cards. Throws like validate_checkpoint().
void expect_equilibria(const Model& model);

}  // namespace blocks::output
