#include "dynamics/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks::dynamics {

Vec2 extent(const Blocks& blocks, int b) {
  const auto arms = blocks.arm.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  return arms.rowwise().maxCoeff() - arms.rowwise().minCoeff();
}

double safe_fraction(double damping, int contacts) {
  const double n = contacts;
  return (std::sqrt(1.0 + 3.0 * n * damping * damping) - damping * std::sqrt(3.0 * n)) /
         std::sqrt(6.0 * n);
}

TimeStep choose_time_step(const Model& model) {
  const Settings& settings = model.settings;
  const Blocks& blocks = model.blocks;
  const double stiffness =
      std::max(settings.normal_stiffness, settings.shear_stiffness);

  TimeStep best{std::numeric_limits<double>::infinity(), -1, blocks.size(), false};
  for (int b = 0; b < blocks.size(); ++b) {
    const double dt = settings.fraction * 2.0 * std::sqrt(blocks.mass[b] / stiffness);
    if (dt < best.dt)
      best = {dt, b, blocks.size(), false};
  }
  if (settings.rigid)
    return best;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b))
      continue;
    const Material& material = settings.materials.at(blocks.material[b]);
    const double dt = 0.5 * extent(blocks, b).minCoeff() *
                      std::sqrt(material.density / material.c11());
    if (dt < best.dt)
      best = {dt, b, blocks.size(), true};
  }
  return best;
}

}  // namespace blocks::dynamics
