// Validation of the decisions that a checkpoint contains.
#pragma once

#include "model/model.hpp"

namespace blocks::output {

/// Expects pairs of different blocks in ascending order, and as many contacts and poses
/// as they count.
void expect_kept(const Model& model);

}  // namespace blocks::output
