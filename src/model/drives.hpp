// Driven blocks: fixed blocks that move at a given velocity (DRIVE,
// docs/laws.md#driven-blocks), or at one that follows from the stress on a side (SERVO,
// docs/rest.md#servos).
#pragma once

#include "model/model.hpp"

namespace blocks {

/// Makes a fixed block move as `drive` tells. Blocks::velocity and spin of the block
/// have these values from then on. A block driven at velocity 0 stands still, but
/// touches fixed blocks.
void drive_block(Model& model, const Drive& drive);

/// Makes a fixed or driven block move as `servo` tells. It stands still until the next
/// step. A servo or drive that the block had is replaced.
void start_servo(Model& model, const Servo& servo);

/// The side of a servo.
struct ServoSide {
  Vec2 outwards;  ///< unit normal
  double length;  ///< [L]
};
ServoSide side_of(const Blocks& blocks, const Servo& servo);

/// Returns the normal stress on the side of a servo, [F/L^2], tension positive. It is
/// that of the springs of all listed contacts of its block.
double stress_on(const Model& model, const Servo& servo);

/// Ends the drive of a block if it has one, and its servo. Its velocity and spin stay
/// as they are.
void end_drive(Model& model, int block);

}  // namespace blocks
