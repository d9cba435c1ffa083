// The motion kernel gives the bits of the equations evaluated block by block, with
// every instruction set.
#include "dynamics/kernels/motion_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "dynamics/motion.hpp"
#include "dynamics/time_step.hpp"

namespace blocks::dynamics {
namespace {

// The equations of motion, evaluated for one block after the other.
namespace plain {

Eigen::Matrix2d cayley_rotation(double turn) {
  const double h = 0.5 * turn, scale = 1.0 / (1.0 + h * h);
  const double c = (1.0 - h * h) * scale, s = 2.0 * h * scale;
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

void rotate_symmetric(Eigen::Ref<Eigen::Vector4d> s, const Eigen::Matrix2d& r) {
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
    const double least = least_moment_share * (0.5 * (trace * trace));
    determinant = whole > least ? whole : least;
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

Symmetric driving_stress(const Blocks& blocks, int b) {
  const auto applied = blocks.applied.col(b), internal = blocks.stress.col(b);
  return {applied[0] - internal[0], 0.5 * (applied[1] + applied[2]) - internal[1],
          applied[3] - internal[3]};
}

double norm(const Symmetric& t) {
  return std::sqrt((t.xx * t.xx + t.yy * t.yy) + 2.0 * (t.xy * t.xy));
}

/// Returns the work of local damping.
double damp_unbalanced(Blocks& blocks, int b, const Settings& settings, double dt) {
  const double alpha_dt = settings.local_damping * dt;
  double velocity_work = 0.0, spin_work = 0.0, strain_work = 0.0;
  const Vec2 a = blocks.force.col(b) / blocks.mass[b] + settings.gravity;
  auto v = blocks.velocity.col(b);
  const double acceleration = std::sqrt(a.x() * a.x() + a.y() * a.y());
  if (const double speed = std::sqrt(v.x() * v.x() + v.y() * v.y()); speed > 0.0) {
    const double loss = alpha_dt * acceleration / speed;
    v = Vec2(v.x() - loss * v.x(), v.y() - loss * v.y());
    velocity_work = alpha_dt * blocks.mass[b] * acceleration * speed;
  }
  double& spin = blocks.spin[b];
  if (const double moment = std::abs(blocks.moment[b]), was = spin; was != 0.0) {
    const double slows = alpha_dt * (moment / blocks.inertia[b]);
    spin -= was > 0.0 ? slows : -slows;
    spin_work = alpha_dt * moment * std::abs(was);
  }
  if (settings.rigid)
    return velocity_work + spin_work;
  auto rate = blocks.strain_rate.col(b);
  const Symmetric before = {rate[0], rate[1], rate[3]};
  const double force = norm(driving_stress(blocks, b));
  if (const double speed = norm(before); speed > 0.0) {
    const double scale = alpha_dt * force / speed;
    const Symmetric loss = StrainMass(blocks, b).accelerations(
        {scale * before.xx, scale * before.xy, scale * before.yy});
    rate[0] -= loss.xx;
    rate[1] -= loss.xy;
    rate[2] = rate[1];
    rate[3] -= loss.yy;
    strain_work = alpha_dt * blocks.area[b] * force * speed;
  }
  return velocity_work + spin_work + strain_work;
}

void update_velocities(Blocks& blocks, int b, const Vec2& gravity, double dt) {
  blocks.velocity.col(b) += dt * (blocks.force.col(b) / blocks.mass[b] + gravity);
  blocks.spin[b] += dt * (blocks.moment[b] / blocks.inertia[b]);
}

/// rates: strain rates before the step. Returns the work of MDAMP.
double update_strain_rates(Blocks& blocks, int b, const Settings& settings,
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

void update_stress(Blocks& blocks, int b, const Settings& settings, double dt) {
  const Material& m = settings.materials.at(blocks.material[b]);
  const auto rate = blocks.strain_rate.col(b);
  auto stress = blocks.stress.col(b);
  stress[0] += dt * (m.c11() * rate[0] + m.c12() * rate[3]);
  stress[1] += dt * (2.0 * m.shear_modulus) * rate[1];
  stress[2] = stress[1];
  stress[3] += dt * (m.c12() * rate[0] + m.c11() * rate[3]);
}

bool inside(const Blocks& blocks, int b, const Settings& settings) {
  const auto corners =
      blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  return (corners.rowwise().minCoeff().array() >= settings.lower.array()).all() &&
         (corners.rowwise().maxCoeff().array() <= settings.upper.array()).all();
}

using Tensor = Eigen::Matrix<double, 2, 2, Eigen::RowMajor>;

/// Returns the new gradient. `change` bounds the change of an arm no longer than
/// `longest`.
Tensor move_arms(const Blocks& blocks, int b, const Tensor& step, double turn,
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
void move_block(Blocks& blocks, int b, const MotionBounds& bounds,
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

}  // namespace plain

/// Random blocks, some of them fixed.
struct Scene {
  std::mt19937_64 random;
  Blocks blocks;
  MotionBounds bounds;
  Settings settings;
  BlockRange range;
  Eigen::VectorXd damped;  ///< work of LOCDAMP and MDAMP

  explicit Scene(unsigned seed) : random(seed) {
    settings.rigid = seed % 2 == 0;
    settings.materials[1] = {3.0, 1.25, 1.0};
    settings.materials[2] = {7.0, 2.75, 1.0};
    const double damping[] = {0.0, 0.1, 1.0};
    settings.materials[1].damping = damping[seed / 2 % 3];
    settings.materials[2].damping = damping[seed / 6 % 3];
    settings.gravity = {number(), number()};
    settings.local_damping = below(4) * 0.25;
    settings.lower = {-10.0, -11.0}, settings.upper = {12.0, 10.0};
    const int count = 1 + below(seed % 10 == 0 ? 200 : 40);
    for (int b = 0; b < count; ++b) {
      blocks.first_corner.push_back(blocks.corners() + 3 +
                                    below(below(8) == 0 ? 125 : 4));
      blocks.material.push_back(1 + below(2));
      blocks.fixity.push_back(below(6) == 0 ? Fixity::by_user : Fixity::free);
    }
    range.begin = below(count);
    range.end = range.begin + below(count - range.begin + 1);
    damped = Eigen::VectorXd::Zero(count);
    const int corners = blocks.corners();
    fill(blocks.arm, 2, corners), fill(blocks.corner, 2, corners);
    for (auto* row : {&blocks.area, &blocks.mass, &blocks.inertia}) {
      fill(*row, count, 1);
      *row = row->cwiseAbs().array() + 0.125;
    }
    for (auto* row : {&blocks.angle, &blocks.spin, &blocks.moment})
      fill(*row, count, 1);
    for (auto* rows : {&blocks.velocity, &blocks.force, &blocks.centroid})
      fill(*rows, 2, count);
    for (auto* rows : {&blocks.applied, &blocks.stress, &blocks.strain_rate})
      fill(*rows, 4, count);
    fill(blocks.second_moment, 4, count);
    for (int b = 0; b < count; ++b) {
      // Some have so little in one direction that rounding hides it.
      auto moment = blocks.second_moment.col(b);
      const double x = moment[0], y = moment[1], thin = below(4) == 0 ? 1e-9 : 1.0;
      moment << x * x + thin * y * y + 0.125, x * y, x * y, y * y + thin * 0.125;
    }
    blocks.centroid *= 3.0;
    fill(blocks.gradient, 4, count);
    for (int b = 0; settings.rigid && b < count; ++b) {
      const double angle = number();
      blocks.gradient.col(b) << std::cos(angle), -std::sin(angle), std::sin(angle),
          std::cos(angle);
    }
    bounds.start(blocks_with_owners(), settings.rigid);
    if (seed % 3 == 0)
      spoil();
  }
  int below(int count) { return static_cast<int>(random() % count); }

 private:
  /// Returns a random number, in one of ten cases zero.
  double number() {
    return below(10) == 0 ? 0.0 : std::uniform_real_distribution(-4.0, 4.0)(random);
  }
  template <class Matrix> void fill(Matrix& matrix, int rows, int columns) {
    matrix.resize(rows, columns);
    for (double& x : matrix.reshaped())
      x = number();
  }
  const Blocks& blocks_with_owners() {
    for (int b = 0; b < blocks.size(); ++b)
      blocks.corner_block.insert(blocks.corner_block.end(), blocks.corners_of(b), b);
    return blocks;
  }
  /// Sets one random value of a random block to a value that only a failed run has.
  void spoil() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double bad[] = {1e150,     -1e160,   1e200,       1e308,
                              -infinity, infinity, std::nan("")};
    const double x = bad[below(7)];
    const int b = below(blocks.size());
    switch (below(4)) {
    case 0:
      blocks.velocity(below(2), b) = x;
      break;
    case 1:
      blocks.spin[b] = x;
      break;
    case 2:
      blocks.centroid(below(2), b) = x;
      break;
    default:
      blocks.strain_rate(below(4), b) = x;
    }
  }
};

/// Returns the bits of all values that motion writes. All NaNs are the same, because
/// the sign of a NaN is not defined.
std::vector<std::uint64_t> bits(const Scene& scene) {
  const Blocks& blocks = scene.blocks;
  std::vector<std::uint64_t> found;
  const auto add = [&](const double* from, std::ptrdiff_t count) {
    for (const double* x = from; x < from + count; ++x) {
      std::uint64_t word;
      std::memcpy(&word, x, sizeof word);
      found.push_back(std::isnan(*x) ? 1 : word);
    }
  };
  for (const auto* rows : {&blocks.corner, &blocks.centroid, &blocks.velocity})
    add(rows->data(), rows->size());
  for (const auto* rows :
       {&blocks.gradient, &blocks.applied, &blocks.stress, &blocks.strain_rate})
    add(rows->data(), rows->size());
  for (const auto* row : {&blocks.angle, &blocks.spin, &scene.damped})
    add(row->data(), row->size());
  return found;
}

Displacement step_plainly(Scene& scene, double dt) {
  Displacement result;
  double sum = 0.0;
  for (int b = scene.range.begin; b < scene.range.end; ++b) {
    if (!scene.blocks.is_free(b))
      continue;
    const Eigen::Vector4d rates = scene.blocks.strain_rate.col(b);
    scene.damped[b] = plain::damp_unbalanced(scene.blocks, b, scene.settings, dt);
    plain::update_velocities(scene.blocks, b, scene.settings.gravity, dt);
    if (!scene.settings.rigid) {
      scene.damped[b] +=
          plain::update_strain_rates(scene.blocks, b, scene.settings, rates, dt);
      plain::update_stress(scene.blocks, b, scene.settings, dt);
    }
    plain::move_block(scene.blocks, b, scene.bounds, scene.settings, dt, result, sum);
  }
  result.finite = std::isfinite(sum);
  return result;
}

Displacement step_by(const Kernels& by, Scene& scene, double dt) {
  Blocks& blocks = scene.blocks;
  const StepMotion step = {.dt = dt,
                           .kick = dt,
                           .gravity = scene.settings.gravity,
                           .damped = scene.damped.data()};
  const Eigen::Matrix4Xd rates = blocks.strain_rate.middleCols(
      scene.range.begin, scene.range.end - scene.range.begin);
  damp_unbalanced(blocks, scene.range, scene.settings, step, by);
  update_velocities(blocks, scene.range, scene.settings.gravity, dt, by);
  if (!scene.settings.rigid) {
    if (damps_vibration(scene.settings))
      update_damped_strain(blocks, scene.range, scene.settings, step, rates.data(), by);
    else
      update_strain(blocks, scene.range, scene.settings, dt, dt, by);
  }
  return move_corners(blocks, scene.range, scene.bounds, scene.settings, dt, by);
}

TEST(MotionKernel, GivesTheBitsOfTheScalarEquations) {
  int left = 0, stayed = 0, failed = 0;
  for (unsigned seed = 0; seed < 4000; ++seed) {
    const Scene scene(seed);
    for (const Kernels& by : all_kernels()) {
      Scene expected = scene, found = scene;
      bool finite = true;
      for (int k = 0; k < 3 && finite; ++k) {
        const double dt = 0.125 / (1 << k);
        const Displacement wanted = step_plainly(expected, dt);
        const Displacement moved = step_by(by, found, dt);
        ASSERT_EQ(bits(found), bits(expected)) << by.name << ' ' << seed;
        ASSERT_EQ(moved.largest, wanted.largest) << seed;
        ASSERT_EQ(moved.block, wanted.block) << seed;
        ASSERT_EQ(moved.bound, wanted.bound) << seed;
        ASSERT_EQ(moved.finite, wanted.finite) << seed;
        finite = moved.finite;
        if (finite) {
          ASSERT_EQ(moved.left_domain, wanted.left_domain) << seed;
        }
        left += wanted.left_domain, stayed += !wanted.left_domain, failed += !finite;
      }
    }
  }
  EXPECT_GT(left, 1000);
  EXPECT_GT(stayed, 1000);
  EXPECT_GT(failed, 100);
}

// Threads and batches must not decide whether a block shares its batch with damped
// ones.
TEST(MotionKernel, MdampKeepsTheBitsOfBlocksOfOtherMaterials) {
  int damped = 0, undamped = 0;
  for (unsigned seed = 1; seed < 2000; seed += 2) {
    Scene scene(seed);
    Blocks& blocks = scene.blocks;
    for (int b = 0; b < blocks.size(); b += 3) {  // 0 times a rate can change a zero
      blocks.applied.col(b).setConstant(-0.0), blocks.stress.col(b).setZero();
      blocks.strain_rate.col(b).setConstant(-0.0);
    }
    for (const double z : {0.0, 0.5})
      for (const Kernels& by : all_kernels()) {
        Scene plain = scene, found = scene;
        found.settings.materials[1].damping = 0.0;
        found.settings.materials[2].damping = z;
        const StepMotion step = {.dt = 0.125, .kick = 0.0625};
        const Eigen::Matrix4Xd rates = blocks.strain_rate.middleCols(
            scene.range.begin, scene.range.end - scene.range.begin);
        update_strain(plain.blocks, scene.range, scene.settings, 0.0625, 0.125, by);
        update_damped_strain(found.blocks, scene.range, found.settings, step,
                             rates.data(), by);
        for (int b = scene.range.begin; b < scene.range.end; ++b)
          if (z > 0.0 && blocks.is_free(b) && blocks.material[b] == 2) {
            plain.blocks.strain_rate.col(b) = found.blocks.strain_rate.col(b);
            plain.blocks.stress.col(b) = found.blocks.stress.col(b);
            ++damped;
          } else {
            ++undamped;
          }
        ASSERT_EQ(bits(found), bits(plain)) << by.name << ' ' << seed;
      }
  }
  EXPECT_GT(damped, 1000);
  EXPECT_GT(undamped, 1000);
}

// Two blocks in any lanes are equally fast.
TEST(MotionKernel, ReportsTheFirstOfEquallyFastBlocks) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    Scene scene(10 * seed);
    scene.settings.rigid = true;
    const int count = scene.blocks.size();
    scene.blocks.fixity.assign(count, Fixity::free);
    scene.blocks.force.setZero(), scene.blocks.moment.setZero();
    scene.blocks.spin.setZero(), scene.blocks.velocity.setZero();
    scene.blocks.centroid.setZero();
    scene.settings.gravity = {0, 0};
    const int first = scene.below(count), second = scene.below(count);
    scene.blocks.velocity(0, first) = scene.blocks.velocity(1, second) = 1.0;
    scene.range = {0, count};
    for (const Kernels& by : all_kernels()) {
      Scene found = scene;
      const int named = step_by(by, found, 0.5).block;
      if (first != second) {
        ASSERT_EQ(named, std::min(first, second));
      }
    }
  }
}

}  // namespace
}  // namespace blocks::dynamics
