#include "model/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/drives.hpp"
#include "model/load_sizes.hpp"

namespace blocks {
double time_of_forces(const Model& model) {
  return model.steps > 0 ? model.time - model.time_step.dt : model.time;
}

namespace {

/// Returns the norm of the forces of the loads, [F].
double sum_of_loads(const Model& model, double time) {
  double sum = 0.0;
  each_load(model, time, [&](int, double size) { sum += size; });
  return sum;
}

double unbalanced_force(const Model& model, int b, const Vec2& gravity) {
  const Blocks& blocks = model.blocks;
  for (const Servo& servo : model.servos)
    if (servo.block == b)
      return std::abs(stress_on(model, servo) - servo.target) *
             side_of(blocks, servo).length;
  if (!blocks.is_free(b))
    return 0.0;
  const double gyration = std::sqrt(blocks.inertia[b] / blocks.mass[b]);
  double sum = (blocks.force.col(b) + blocks.mass[b] * gravity).norm() +
               std::abs(blocks.moment[b]) / gyration;
  if (!model.settings.rigid) {
    const auto stress = blocks.stress.col(b), applied = blocks.applied.col(b);
    const double shear = 0.5 * (applied[1] + applied[2]) - stress[1];
    const double xx = applied[0] - stress[0], yy = applied[3] - stress[3];
    sum +=
        blocks.area[b] * std::sqrt(xx * xx + 2.0 * shear * shear + yy * yy) / gyration;
  }
  return sum;
}

}  // namespace

double unbalanced_force(const Model& model, int b) {
  return unbalanced_force(model, b, model.settings.gravity_at(time_of_forces(model)));
}

void unbalanced_forces(const Model& model, Eigen::VectorXd& forces) {
  const Vec2 gravity = model.settings.gravity_at(time_of_forces(model));
  forces.resize(model.blocks.size());
  for (int b = 0; b < model.blocks.size(); ++b)
    forces[b] = unbalanced_force(model, b, gravity);
}

bool is_damped_to_rest(const Settings& settings) {
  return settings.local_damping > 0.0 || settings.kinetic_damping;
}

double unbalanced_ratio(const Model& model) {
  const Blocks& blocks = model.blocks;
  const double time = time_of_forces(model);
  const Vec2 gravity = model.settings.gravity_at(time);
  double unbalanced = 0.0, all = sum_of_loads(model, time);
  for (int b = 0; b < blocks.size(); ++b) {
    unbalanced += unbalanced_force(model, b, gravity);
    if (blocks.is_free(b))
      all += blocks.mass[b] * gravity.norm();
  }
  for (const Contact& contact : model.contacts)
    all += Vec2(contact.normal_force, contact.shear_force).norm();
  for (const PlaneContact& contact : model.plane_contacts)
    all += contact.normal_force;
  return all > 0.0 ? unbalanced / all : 0.0;
}

bool loads_will_change(const Model& model) {
  const GravityRamp& ramp = model.settings.gravity_ramp;
  if (ramp.duration > 0.0 && model.time < ramp.begin + ramp.duration)
    return true;
  if (model.loads.water.will_change(model.time))
    return true;
  const TimeFunction& function = model.loads.function;
  double last_change = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < function.t.size(); ++i)
    if (function.p[i] != function.p[i - 1])
      last_change = function.t[i];
  const auto is_coming = [&](const auto& load) {
    return model.time < load.arrival + std::max(0.0, last_change);
  };
  return std::any_of(model.loads.pressures.begin(), model.loads.pressures.end(),
                     is_coming) ||
         std::any_of(model.loads.forces.begin(), model.loads.forces.end(), is_coming);
}

}  // namespace blocks
