#include "dynamics/energy/block_energy.hpp"

namespace blocks::dynamics {
namespace {

const Material& material_of(const Model& model, int b) {
  return model.settings.materials.at(model.blocks.material[b]);
}

}  // namespace

BlockMasses masses_of(const Blocks& blocks, int b, bool rigid) {
  const double mass = blocks.inertial_mass(b);
  const double inertia = blocks.has_scaled_masses()
                             ? blocks.scale[b] * blocks.inertia[b]
                             : blocks.inertia[b];
  BlockMasses masses{mass, inertia, {0.0, 0.0, 0.0}};
  if (!rigid) {
    using Rows = Eigen::Matrix<double, 2, 2, Eigen::RowMajor>;
    const Eigen::Map<const Rows> gradient(blocks.gradient.col(b).data());
    const Eigen::Map<const Rows> moment(blocks.second_moment.col(b).data());
    const Eigen::Matrix2d strain =
        3.0 * mass / blocks.mass[b] * (gradient * moment * gradient.transpose());
    masses.strain[0] = strain(0, 0);
    masses.strain[1] = strain(1, 1);
    masses.strain[2] = strain(0, 1);
  }
  return masses;
}

BlockMotion turned_back(const BlockMotion& motion, double dt) {
  const double h = 0.5 * motion.spin * dt, scale = 1.0 / (1.0 + h * h);
  const double c = (1.0 - h * h) * scale, s = -2.0 * h * scale;
  const auto& [r11, r22, r12] = motion.rate;
  const double t11 = c * r11 - s * r12, t12 = c * r12 - s * r22;
  const double t21 = s * r11 + c * r12, t22 = s * r12 + c * r22;
  return {motion.velocity,
          motion.spin,
          {t11 * c - t12 * s, t21 * s + t22 * c, t11 * s + t12 * c}};
}

double kinetic_energy(const Blocks& blocks, int b, bool rigid) {
  if (!blocks.is_free(b))
    return 0.0;
  const BlockMotion motion = motion_of(blocks, b);
  return kinetic_energy(masses_of(blocks, b, rigid), motion, motion);
}

double strain_energy(const Model& model, int b) {
  const Blocks& blocks = model.blocks;
  if (model.settings.rigid || blocks.is_removed(b))
    return 0.0;
  const Material& material = material_of(model, b);
  const auto s = blocks.stress.col(b);
  const double c11 = material.c11(), c12 = material.c12();
  const double normal = (c11 * (s[0] * s[0] + s[3] * s[3]) - 2.0 * c12 * s[0] * s[3]) /
                        ((c11 - c12) * (c11 + c12));
  const double shear = s[1] * s[1] / material.shear_modulus;
  return 0.5 * blocks.area[b] * (normal + shear);
}

BlockEnergy energy_of(const Model& model, int b) {
  return {kinetic_energy(model.blocks, b, model.settings.rigid),
          strain_energy(model, b)};
}

double stress_work(const Blocks& blocks, int b, double dt) {
  const auto s = blocks.stress.col(b), rate = blocks.strain_rate.col(b);
  const double power = s[0] * rate[0] + s[3] * rate[3] + 2.0 * s[1] * rate[1];
  return blocks.area[b] * power * dt;
}

double last_stress_work(const Model& model, int b) {
  const Blocks& blocks = model.blocks;
  const Material& material = material_of(model, b);
  const double dt = model.time_step.dt;
  const auto rate = blocks.strain_rate.col(b);
  const double growth = material.c11() * (rate[0] * rate[0] + rate[3] * rate[3]) +
                        2.0 * material.c12() * rate[0] * rate[3] +
                        4.0 * material.shear_modulus * rate[1] * rate[1];
  return stress_work(blocks, b, dt) - 0.5 * blocks.area[b] * growth * dt * dt;
}

}  // namespace blocks::dynamics
