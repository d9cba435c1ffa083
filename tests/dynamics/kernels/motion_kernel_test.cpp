// The motion kernel gives the bits of the equations evaluated block by block, with
// every instruction set.
#include "dynamics/kernels/motion_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "dynamics/motion.hpp"
#include "dynamics/kernels/plain_motion.hpp"
#include "dynamics/preparation/time_step.hpp"

namespace blocks::dynamics {
namespace {

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
  if (!scene.settings.rigid)
    update_strain(blocks, scene.range, scene.settings, step,
                  damps_vibration(scene.settings) ? rates.data() : nullptr, by);
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
        update_strain(plain.blocks, scene.range, scene.settings, step, nullptr, by);
        update_strain(found.blocks, scene.range, found.settings, step, rates.data(),
                      by);
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
