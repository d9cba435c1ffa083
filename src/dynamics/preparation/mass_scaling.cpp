#include "dynamics/preparation/mass_scaling.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/preparation/packed_contacts.hpp"
#include "dynamics/preparation/time_step.hpp"

namespace blocks::dynamics {
namespace {

/// Multiplies the velocities of block b by a factor.
void multiply_motion(Blocks& blocks, int b, double factor) {
  blocks.velocity.col(b) *= factor;
  blocks.spin[b] *= factor;
  blocks.strain_rate.col(b) *= factor;
}

}  // namespace

void count_time_from_here(Model& model) {
  model.time_origin = model.time;
  model.step_origin = model.steps;
}

bool may_scale_masses(const Model& model) {
  const Blocks& blocks = model.blocks;
  if (!model.settings.mass_scaling || !model.loads.quiet_sides.empty())
    return false;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      return true;
  return false;
}

void begin_mass_scaling(Model& model) {
  Blocks& blocks = model.blocks;
  const Eigen::VectorXd critical = steps_of_blocks(model, contact_shares(model));
  double mass = 0.0, stiffness = 0.0;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b)) {
      mass += blocks.mass[b];
      stiffness += blocks.mass[b] / (critical[b] * critical[b]);
    }
  const double dt = std::sqrt(mass / stiffness);
  blocks.scale = Eigen::VectorXd::Ones(blocks.size());
  int smallest = -1;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b)) {
      const double root = dt / critical[b];
      blocks.scale[b] = root * root;
      multiply_motion(blocks, b, 1.0 / root);
      if (smallest < 0 || critical[b] < critical[smallest])
        smallest = b;
    }
  model.time_step = {dt, smallest, blocks.size(), false, false};
  count_time_from_here(model);
}

void end_mass_scaling(Model& model) {
  Blocks& blocks = model.blocks;
  if (!blocks.has_scaled_masses())
    return;
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      multiply_motion(blocks, b, std::sqrt(blocks.scale[b]));
  blocks.scale.resize(0);
  model.time_step = choose_time_step(model);
  count_time_from_here(model);
}

MassFactors mass_factors(const Blocks& blocks) {
  MassFactors factors;
  if (!blocks.has_scaled_masses())
    return factors;
  bool first = true;
  for (int b = 0; b < blocks.size(); ++b) {
    if (!blocks.is_free(b))
      continue;
    const double scale = blocks.scale[b];
    factors.min = first ? scale : std::min(factors.min, scale);
    factors.largest = first ? scale : std::max(factors.largest, scale);
    first = false;
  }
  return factors;
}

}  // namespace blocks::dynamics
