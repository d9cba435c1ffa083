// What holds for every state a run can leave, field by field: a checkpoint that was
// made up, with a right checksum, is refused before a step is made with it. Knows the
// model and the names of visit_model, no files.
#pragma once

#include "output/checkpoint.hpp"

namespace blocks::output {

/// Throws hdf5::Failure, "blocks/mass: value 3 is -1, expected a number above 0": a
/// number that is not finite or out of its range, columns of different lengths, an
/// index of nothing, contacts out of order. Every field of `info` and `model` is looked
/// at.
void expect_possible(const Model& model, const CheckpointInfo& info);

}  // namespace blocks::output
