// Checks the contacts with symmetry planes in a checkpoint. Part of
// checkpoint_validation.cpp.
#pragma once

#include "model/model.hpp"

namespace blocks::output {

/// Expects valid contacts with planes, in their order. Throws like
/// validate_checkpoint().
void expect_plane_contacts(const Model& model);

}  // namespace blocks::output
