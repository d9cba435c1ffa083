// Checkpoint validation: checks conditions that hold for every state of a run. Those of
// one field stand beside its name (model_fields.hpp); those that relate fields to each
// other are here. A fabricated checkpoint with a correct checksum is thus rejected
// before it is used.
#pragma once

#include "output/checkpoint/checkpoint.hpp"

namespace blocks::output {

/// Checks every field of `info` and `model`. Throws hdf5::Failure, such as
/// "blocks/mass: value 3 is -1, expected a number above 0". It rejects numbers that are
/// not finite or out of range, columns of different lengths, invalid indices, and
/// contacts out of order.
void validate_checkpoint(const Model& model, const CheckpointInfo& info);

}  // namespace blocks::output
