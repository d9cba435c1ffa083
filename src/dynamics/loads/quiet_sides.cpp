#include "dynamics/loads/quiet_sides.hpp"

#include <cmath>

#include "dynamics/loads/applied_force.hpp"
#include "dynamics/loads/point_velocity.hpp"

namespace blocks::dynamics {
QuietEnds ends_of(const Blocks& blocks, const QuietSide& quiet) {
  const int c = blocks.first_corner[quiet.block] + quiet.side;
  return {c, blocks.next[c]};
}

Dashpots dashpots_of(const Blocks& blocks, const QuietSide& quiet) {
  const auto [c1, c2] = ends_of(blocks, quiet);
  const Vec2 a = blocks.corner.col(c2) - blocks.corner.col(c1);
  const double density = blocks.mass[quiet.block] / blocks.area[quiet.block];
  const double half = 0.5 * density / std::sqrt(a.squaredNorm());
  return {a, Vec2(-a.y(), a.x()), half * quiet.cp, half * quiet.cs};
}

QuietForces forces_of(const Blocks& blocks, const QuietSide& quiet) {
  const auto [c1, c2] = ends_of(blocks, quiet);
  const Dashpots dashpot = dashpots_of(blocks, quiet);
  QuietForces forces;
  forces.arm[0] = blocks.present_arm(c1), forces.arm[1] = blocks.present_arm(c2);
  for (int i = 0; i < 2; ++i) {
    const Vec2 v = point_velocity(blocks, quiet.block, forces.arm[i]);
    forces.velocity[i] = v;
    forces.force[i] = -(dashpot.normal * dashpot.p.dot(v)) * dashpot.p -
                      (dashpot.along * dashpot.a.dot(v)) * dashpot.a;
  }
  return forces;
}

void add_quiet_sides(Blocks& blocks, const std::vector<QuietSide>& sides) {
  for (const QuietSide& quiet : sides) {
    const QuietForces forces = forces_of(blocks, quiet);
    add_force(blocks, quiet.block, forces.arm[0], quiet.first + forces.force[0]);
    add_force(blocks, quiet.block, forces.arm[1], quiet.second + forces.force[1]);
  }
}

QuietPower power_of_quiet_sides(const Model& model) {
  QuietPower power;
  for (const QuietSide& quiet : model.loads.quiet_sides) {
    const QuietForces forces = forces_of(model.blocks, quiet);
    power.constant += quiet.first.dot(forces.velocity[0]);
    power.constant += quiet.second.dot(forces.velocity[1]);
    for (int i = 0; i < 2; ++i)
      power.dashpots += forces.force[i].dot(forces.velocity[i]);
  }
  return power;
}

}  // namespace blocks::dynamics
