#include "dynamics/loads.hpp"

#include "dynamics/applied_force.hpp"
#include "dynamics/symmetry_planes.hpp"

namespace blocks::dynamics {
namespace {

void add_pressure(Blocks& blocks, const Pressure& pressure, double factor) {
  const int b = pressure.block;
  const int c1 = blocks.first_corner[b] + pressure.side, c2 = blocks.next[c1];
  const Vec2 along = blocks.corner.col(c2) - blocks.corner.col(c1);
  // opposite to the outward normal, of length L
  const Vec2 inward(along.y(), -along.x());
  const double p1 = factor * pressure.p1, p2 = factor * pressure.p2;
  add_force(blocks, b, blocks.present_arm(c1), (2.0 * p1 + p2) / 6.0 * inward);
  add_force(blocks, b, blocks.present_arm(c2), (p1 + 2.0 * p2) / 6.0 * inward);
}

}  // namespace

bool has_loads(const Model& model) {
  return model.plane_contacts.size() > 0 || !model.loads.none();
}

Extremes add_loads(Model& model) {
  Blocks& blocks = model.blocks;
  const Loads& loads = model.loads;
  blocks.force.setZero();
  blocks.moment.setZero();
  if (!model.settings.rigid)
    blocks.applied.setZero();
  const Extremes at_planes = add_plane_forces(blocks, model.plane_contacts,
                                              model.settings, model.time_step.dt);
  for (const Pressure& pressure : loads.pressures)
    add_pressure(blocks, pressure, loads.function.factor(model.time, pressure.arrival));
  for (const CentroidForce& load : loads.forces)
    blocks.force.col(load.block) +=
        loads.function.factor(model.time, load.arrival) * load.force;
  return at_planes;
}

}  // namespace blocks::dynamics
