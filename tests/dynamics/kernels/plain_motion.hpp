// The equations of motion, evaluated for one block after the other.
#pragma once

#include <algorithm>
#include <cmath>

#include "dynamics/kernels/motion_kernel.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/preparation/time_step.hpp"

namespace blocks::dynamics::plain {

inline Eigen::Matrix2d cayley_rotation(double turn) {
  const double h = 0.5 * turn, scale = 1.0 / (1.0 + h * h);
  const double c = (1.0 - h * h) * scale, s = 2.0 * h * scale;
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

inline void rotate_symmetric(Eigen::Ref<Eigen::Vector4d> s, const Eigen::Matrix2d& r) {
  const Eigen::Matrix2d t =
      r * (Eigen::Matrix2d() << s[0], s[1], s[1], s[3]).finished() * r.transpose();
  const double shear = 0.5 * (t(0, 1) + t(1, 0));
  s << t(0, 0), shear, shear, t(1, 1);
}

/// A symmetric tensor.
struct Symmetric {
  double xx, xy, yy;
};

/// The tensor M of effective masses, and its determinant as the kernel takes it.
struct StrainMass {
  Symmetric m;
  double trace, determinant;

  StrainMass(const Blocks& blocks, int b) {
    const auto g = blocks.gradient.col(b), j = blocks.second_moment.col(b);
    const double factor = 3.0 / blocks.area[b];
    const double a11 = g[0] * j[0] + g[1] * j[1], a12 = g[0] * j[1] + g[1] * j[3];
    const double a21 = g[2] * j[0] + g[3] * j[1], a22 = g[2] * j[1] + g[3] * j[3];
    m = {factor * (a11 * g[0] + a12 * g[1]), factor * (a11 * g[2] + a12 * g[3]),
         factor * (a21 * g[2] + a22 * g[3])};
    trace = m.xx + m.yy;
    const double whole = m.xx * m.yy - m.xy * m.xy;
    const double min = min_moment_share * (0.5 * (trace * trace));
    determinant = whole > min ? whole : min;
  }
  Symmetric accelerations(const Symmetric& s) const {
    const double t11 = m.yy * s.xx - m.xy * s.xy, t12 = m.yy * s.xy - m.xy * s.yy;
    const double t21 = m.xx * s.xy - m.xy * s.xx, t22 = m.xx * s.yy - m.xy * s.xy;
    const double scale = 1.0 / (trace * determinant);
    return {scale * (determinant * s.xx + (t11 * m.yy - t12 * m.xy)),
            scale * (determinant * s.xy + (t12 * m.xx - t11 * m.xy)),
            scale * (determinant * s.yy + (t22 * m.xx - t21 * m.xy))};
  }
  Symmetric square_root() const {
    const double root = std::sqrt(determinant);
    const double scale = 1.0 / std::sqrt(trace + 2.0 * root);
    return {scale * (m.xx + root), scale * m.xy, scale * (m.yy + root)};
  }
};

inline Symmetric driving_stress(const Blocks& blocks, int b) {
  const auto applied = blocks.applied.col(b), internal = blocks.stress.col(b);
  return {applied[0] - internal[0], 0.5 * (applied[1] + applied[2]) - internal[1],
          applied[3] - internal[3]};
}

inline double norm(const Symmetric& t) {
  return std::sqrt((t.xx * t.xx + t.yy * t.yy) + 2.0 * (t.xy * t.xy));
}

/// Returns the work of local damping.
inline double damp_unbalanced(Blocks& blocks, int b, const Settings& settings,
                              double dt) {
  const double alpha_dt = settings.local_damping * dt;
  double velocity_work = 0.0, spin_work = 0.0, strain_work = 0.0;
  const Vec2 a = blocks.force.col(b) / blocks.mass[b] + settings.gravity;
  auto v = blocks.velocity.col(b);
  const double acceleration = std::sqrt(a.x() * a.x() + a.y() * a.y());
  if (const double speed = std::sqrt(v.x() * v.x() + v.y() * v.y());
      speed > slow_motion * alpha_dt * acceleration && speed > 0.0) {
    const double loss = alpha_dt * acceleration / speed;
    v = Vec2(v.x() - loss * v.x(), v.y() - loss * v.y());
    velocity_work = alpha_dt * blocks.mass[b] * acceleration * speed;
  }
  double& spin = blocks.spin[b];
  const double moment = std::abs(blocks.moment[b]), was = spin;
  if (const double slows = alpha_dt * (moment / blocks.inertia[b]);
      std::abs(was) > slow_motion * slows && was != 0.0) {
    spin -= was > 0.0 ? slows : -slows;
    spin_work = alpha_dt * moment * std::abs(was);
  }
  if (settings.rigid)
    return velocity_work + spin_work;
  auto rate = blocks.strain_rate.col(b);
  const Symmetric before = {rate[0], rate[1], rate[3]};
  const double force = norm(driving_stress(blocks, b));
  const double speed = norm(before), scale = alpha_dt * force / speed;
  const Symmetric loss = StrainMass(blocks, b).accelerations(
      {scale * before.xx, scale * before.xy, scale * before.yy});
  if (speed > slow_motion * norm(loss) && speed > 0.0) {
    rate[0] -= loss.xx;
    rate[1] -= loss.xy;
    rate[2] = rate[1];
    rate[3] -= loss.yy;
    strain_work = alpha_dt * blocks.area[b] * force * speed;
  }
  return velocity_work + spin_work + strain_work;
}

inline void update_velocities(Blocks& blocks, int b, const Vec2& gravity, double dt) {
  blocks.velocity.col(b) += dt * (blocks.force.col(b) / blocks.mass[b] + gravity);
  blocks.spin[b] += dt * (blocks.moment[b] / blocks.inertia[b]);
}

/// rates: strain rates before the step. Returns the work of MDAMP.
inline double update_strain_rates(Blocks& blocks, int b, const Settings& settings,
                                  const Eigen::Vector4d& rates, double dt) {
  const StrainMass mass(blocks, b);
  Symmetric driving = driving_stress(blocks, b);
  double work = 0.0;
  const Material& m = settings.materials.at(blocks.material[b]);
  if (m.damping > 0.0) {
    const double factor = 2.0 * m.damping * std::sqrt(m.c11());
    const Symmetric root = mass.square_root();
    const double slows11 = factor * (root.xx * rates[0] + root.xy * rates[1]);
    const double slows12 =
        factor *
        (0.5 * ((root.xx + root.yy) * rates[1] + root.xy * (rates[0] + rates[3])));
    const double slows22 = factor * (root.yy * rates[3] + root.xy * rates[1]);
    driving = {driving.xx - slows11, driving.xy - slows12, driving.yy - slows22};
    work = dt * blocks.area[b] *
           ((slows11 * rates[0] + slows22 * rates[3]) + 2.0 * (slows12 * rates[1]));
  }
  const Symmetric more = mass.accelerations(driving);
  auto rate = blocks.strain_rate.col(b);
  rate[0] += dt * more.xx;
  rate[1] += dt * more.xy;
  rate[2] = rate[1];
  rate[3] += dt * more.yy;
  return work;
}

inline void update_stress(Blocks& blocks, int b, const Settings& settings, double dt) {
  const Material& m = settings.materials.at(blocks.material[b]);
  const auto rate = blocks.strain_rate.col(b);
  auto stress = blocks.stress.col(b);
  stress[0] += dt * (m.c11() * rate[0] + m.c12() * rate[3]);
  stress[1] += dt * (2.0 * m.shear_modulus) * rate[1];
  stress[2] = stress[1];
  stress[3] += dt * (m.c12() * rate[0] + m.c11() * rate[3]);
}

inline bool inside(const Blocks& blocks, int b, const Settings& settings) {
  const auto corners =
      blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  return (corners.rowwise().minCoeff().array() >= settings.lower.array()).all() &&
         (corners.rowwise().maxCoeff().array() <= settings.upper.array()).all();
}

using Tensor = Eigen::Matrix<double, 2, 2, Eigen::RowMajor>;

/// Returns the new gradient. `change` bounds the change of an arm no longer than
/// `longest`.
inline Tensor move_arms(const Blocks& blocks, int b, const Tensor& step, double turn,
                        double longest, bool rigid, double& change) {
  Tensor before;
  before << blocks.gradient(0, b), blocks.gradient(1, b), blocks.gradient(2, b),
      blocks.gradient(3, b);
  if (rigid) {
    if (turn == 0.0) {
      change = longest * std::abs(turn);
      return (Tensor() << before(0, 0), -before(1, 0), before(1, 0), before(0, 0))
          .finished();
    }
    change = longest * (std::abs(turn) + 0x1p-49);
    const double c = step(0, 0) * before(0, 0) - step(1, 0) * before(1, 0);
    const double s = step(1, 0) * before(0, 0) + step(0, 0) * before(1, 0);
    const double scale = 1.5 - 0.5 * (c * c + s * s);
    return (Tensor() << c * scale, -(s * scale), s * scale, c * scale).finished();
  }
  const Tensor g = step * before;
  const double squares =
      (g(0, 0) * g(0, 0) + g(0, 1) * g(0, 1)) + (g(1, 0) * g(1, 0) + g(1, 1) * g(1, 1));
  const double twice_area = 2.0 * (g(0, 0) * g(1, 1) - g(0, 1) * g(1, 0));
  const double gap = (squares - twice_area) * (squares + twice_area);
  const double stretch =
      1.0000001 * std::sqrt(0.5 * (squares + std::sqrt(gap > 0.0 ? gap : 0.0)));
  const double x = step(0, 0) - 1.0, y = step(1, 1) - 1.0;
  const double strain =
      std::sqrt((x * x + y * y) + (step(0, 1) * step(0, 1) + step(1, 0) * step(1, 0)));
  change = longest * stretch * (strain + 0x1p-49) * (1.0 + 2.0 * strain);
  return g;
}

/// Moves a block. `sum` keeps a NaN, which a maximum would drop.
inline void move_block(Blocks& blocks, int b, const MotionBounds& bounds,
                       const Settings& settings, double dt, Displacement& result,
                       double& sum) {
  const Vec2 shift = dt * blocks.velocity.col(b);
  const Vec2 centroid = blocks.centroid.col(b) + shift;
  const double went = (centroid - blocks.centroid.col(b)).norm();
  const double turn = dt * blocks.spin[b];
  const Eigen::Matrix2d rotation = cayley_rotation(turn);
  Tensor step = rotation;
  if (!settings.rigid) {
    rotate_symmetric(blocks.stress.col(b), rotation);
    auto rate = blocks.strain_rate.col(b);
    step = rotation * (Eigen::Matrix2d() << 1.0 + dt * rate[0], dt * rate[1],
                       dt * rate[2], 1.0 + dt * rate[3])
                          .finished();
    rotate_symmetric(rate, rotation);
  }
  blocks.centroid.col(b) = centroid;
  blocks.angle[b] += turn;
  double change = 0.0;
  const Tensor transform =
      move_arms(blocks, b, step, turn, bounds.longest[b], settings.rigid, change);
  blocks.gradient.col(b) << transform(0, 0), transform(0, 1), transform(1, 0),
      transform(1, 1);
  for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
    blocks.corner.col(c) = centroid + transform * Vec2(blocks.arm.col(c));
  const double moved = went + change;
  result.bound = std::max(result.bound, 1.0000001 * (went + 2.0 * change));
  sum += moved + transform.sum();
  if (moved > result.largest)
    result.largest = moved, result.block = b;
  if (!inside(blocks, b, settings))
    result.left_domain = true;
}

}  // namespace blocks::dynamics::plain
