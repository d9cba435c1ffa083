// The sizes of the loads on blocks: pressures, water, forces, servos and quiet sides.
#pragma once

#include <cmath>

#include "model/drives.hpp"
#include "model/model.hpp"

namespace blocks {

/// Calls add(block, size) for each load, where size is the norm of its force at this
/// time, [F]. That of a servo is the force that its side shall hold.
template <class Add> void each_load(const Model& model, double time, const Add& add) {
  const Loads& loads = model.loads;
  const Blocks& blocks = model.blocks;
  for (const Pressure& pressure : loads.pressures) {
    const int c = blocks.first_corner[pressure.block] + pressure.side;
    const double length =
        (blocks.corner.col(blocks.next[c]) - blocks.corner.col(c)).norm();
    add(pressure.block, std::abs(loads.function.factor(time, pressure.arrival)) *
                            length * (std::abs(pressure.p1) + std::abs(pressure.p2)) /
                            2.0);
  }
  if (!loads.water.none()) {
    WaterNow water(loads.water, time);
    for (int b = 0; b < blocks.size(); ++b)
      if (blocks.is_free(b))
        add(b, water.on_block(blocks, b).force.norm());
  }
  for (const CentroidForce& load : loads.forces)
    add(load.block,
        std::abs(loads.function.factor(time, load.arrival)) * load.force.norm());
  for (const Servo& servo : model.servos)
    add(servo.block, std::abs(servo.target) * side_of(blocks, servo).length);
  for (const QuietSide& quiet : loads.quiet_sides)
    add(quiet.block, quiet.first.norm() + quiet.second.norm());
}

}  // namespace blocks
