// Driven blocks: fixed blocks that move at a given velocity (DRIVE,
// docs/laws.md#driven-blocks).
#pragma once

#include "model/model.hpp"

namespace blocks {

/// Makes a fixed block move as `drive` tells. Blocks::velocity and spin of the block
/// have these values from then on. A block driven at velocity 0 stands still, but
/// touches fixed blocks.
void drive_block(Model& model, const Drive& drive);

/// Ends the drive of a block if it has one. Its velocity and spin stay as they are.
void end_drive(Model& model, int block);

}  // namespace blocks
