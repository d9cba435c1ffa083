#include "dynamics/loads.hpp"

#include "dynamics/applied_force.hpp"

namespace blocks::dynamics {
void add_loads(Blocks& blocks, const Loads& loads, double time) {
  for (const Pressure& pressure : loads.pressures) {
    const int b = pressure.block;
    const double factor = loads.function.factor(time, pressure.arrival);
    const int c1 = blocks.first_corner[b] + pressure.side, c2 = blocks.next[c1];
    const Vec2 along = blocks.corner.col(c2) - blocks.corner.col(c1);
    const Vec2 inward(along.y(), -along.x());  // length L, against the outward normal
    const double p1 = factor * pressure.p1, p2 = factor * pressure.p2;
    add_force(blocks, b, blocks.arm.col(c1), (2.0 * p1 + p2) / 6.0 * inward);
    add_force(blocks, b, blocks.arm.col(c2), (p1 + 2.0 * p2) / 6.0 * inward);
  }
  for (const CentroidForce& load : loads.forces)
    blocks.force.col(load.block) +=
        loads.function.factor(time, load.arrival) * load.force;
}

}  // namespace blocks::dynamics
