#include "dynamics/loads/loads.hpp"

#include "dynamics/loads/applied_force.hpp"
#include "dynamics/loads/point_velocity.hpp"
#include "dynamics/loads/quiet_sides.hpp"
#include "dynamics/loads/symmetry_planes.hpp"

namespace blocks::dynamics {

PressureForces forces_of(const Blocks& blocks, const Pressure& pressure,
                         double factor) {
  const int c1 = blocks.first_corner[pressure.block] + pressure.side;
  const int c2 = blocks.next[c1];
  const Vec2 along = blocks.corner.col(c2) - blocks.corner.col(c1);
  // opposite to the outward normal, of length L
  const Vec2 inward(along.y(), -along.x());
  const double p1 = factor * pressure.p1, p2 = factor * pressure.p2;
  return {{blocks.present_arm(c1), blocks.present_arm(c2)},
          {(2.0 * p1 + p2) / 6.0 * inward, (p1 + 2.0 * p2) / 6.0 * inward}};
}

bool has_loads(const Model& model) {
  return !model.plane_contacts.empty() || !model.loads.none();
}

Extremes add_loads(Model& model, const std::vector<int>& shares, Workers& workers) {
  Blocks& blocks = model.blocks;
  blocks.force.setZero();
  blocks.moment.setZero();
  if (!model.settings.rigid)
    blocks.applied.setZero();
  const Extremes at_planes = add_plane_forces(model);
  add_loads_of_cards(model);
  if (!model.loads.water.none())
    workers.each(shares,
                 [&](int, int begin, int end) { add_water(model, begin, end); });
  return at_planes;
}

void add_water(Model& model, int begin, int end) {
  Blocks& blocks = model.blocks;
  WaterNow water(model.loads.water, model.time);
  for (int b = begin; b < end; ++b) {
    if (blocks.is_removed(b))
      continue;
    const BlockWater sum = water.on_block(blocks, b);
    if (!sum.acts)
      continue;
    blocks.force.col(b) += sum.force;
    blocks.moment[b] += sum.moment;
    for (int i = 0; i < 4; ++i)
      blocks.applied(i, b) += sum.sums[i];
  }
}

double power_of_loads(const Model& model) {
  const Blocks& blocks = model.blocks;
  const TimeFunction& function = model.loads.function;
  double power = 0.0;
  for (const Pressure& pressure : model.loads.pressures) {
    const PressureForces forces =
        forces_of(blocks, pressure, function.factor(model.time, pressure.arrival));
    for (int i = 0; i < 2; ++i)
      power +=
          forces.force[i].dot(point_velocity(blocks, pressure.block, forces.arm[i]));
  }
  for (const CentroidForce& load : model.loads.forces)
    power += function.factor(model.time, load.arrival) *
             load.force.dot(Vec2(blocks.velocity.col(load.block)));
  return power;
}

void add_loads_of_cards(Model& model) {
  Blocks& blocks = model.blocks;
  const Loads& loads = model.loads;
  for (const Pressure& pressure : loads.pressures) {
    const PressureForces forces = forces_of(
        blocks, pressure, loads.function.factor(model.time, pressure.arrival));
    for (int i = 0; i < 2; ++i)
      add_force(blocks, pressure.block, forces.arm[i], forces.force[i]);
  }
  for (const CentroidForce& load : loads.forces)
    blocks.force.col(load.block) +=
        loads.function.factor(model.time, load.arrival) * load.force;
  if (!loads.quiet_sides.empty())
    add_quiet_sides(blocks, loads.quiet_sides);
}

}  // namespace blocks::dynamics
