// MDAMP: how fast the vibration of blocks decays, where its energy goes, and that no
// time step makes it grow (docs/cracks.md#damping-of-vibration).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenes/scene.hpp"
#include "tools/fields.hpp"

namespace blocks {
namespace {

using samples::fields;
using scenes::Frame;
using scenes::Scene;

constexpr double right_angle = 0.5 * std::numbers::pi;

/// Returns a material of rock with this Poisson's ratio and damping.
Material rock(double poisson, double damping) {
  return {1e10, 0.5e10 / (1.0 + poisson), 2500.0, {}, damping};
}

/// A model without contacts whose blocks vibrate at about 4000 / s, in steps of
/// `turn` / 4000 s.
Scene vibrating(const Frame& frame, const Material& material, double turn = 0.002) {
  Scene scene(frame);
  Settings& settings = scene.model.settings;
  settings.rigid = false;
  settings.materials[1] = material;
  settings.fraction = turn / 4000.0 / (2.0 * std::sqrt(2500.0 / 1e7));
  return scene;
}

/// Returns the component of the stress of block b in a direction.
double stress_along(const Model& model, int b, const Vec2& way) {
  const auto s = model.blocks.stress.col(b);
  return s[0] * way.x() * way.x() + 2.0 * s[1] * way.x() * way.y() +
         s[3] * way.y() * way.y();
}

/// Returns the second maximum of value() after the start, divided by the first.
template <class Value> double ratio_of_peaks(Scene& scene, const Value& value) {
  scene.prepare();
  double before = value(), now = before, first = 0.0;
  for (int i = 0; i < 100000; ++i) {
    scene.step();
    const double next = value();
    if (now > before && now >= next && now > 0.0) {
      const double bend = before - 2.0 * now + next, slope = 0.5 * (next - before);
      const double peak = now - 0.5 * slope * slope / bend;
      if (first > 0.0)
        return peak / first;
      first = peak;
    }
    before = now, now = next;
  }
  return 0.0;
}

/// The ratio of two successive peaks of an oscillator with this damping ratio.
double decay(double z) {
  return std::exp(-2.0 * std::numbers::pi * z / std::sqrt(1.0 - z * z));
}

// Without lateral strain C11 is the stiffness, whatever the length of the block.
TEST(VibrationDamping, LowersSuccessivePeaksAsAnOscillatorDoes) {
  EXPECT_NEAR(decay(0.1), 0.532, 5e-4);
  for (const double z : {0.1, 0.3})
    for (const Frame& frame : {Frame{}, Frame{right_angle, {30, -7}}})
      for (const Vec2& axis : {Vec2(1, 0), Vec2(0, 1)}) {
        Scene scene = vibrating(frame, rock(0.0, z));
        const int b = scene.box(-1, -0.5, 2, 1);
        const Vec2 way = frame.turn(axis);
        scene.model.blocks.stress.col(b) << way.x() * way.x(), way.x() * way.y(),
            way.x() * way.y(), way.y() * way.y();
        const double ratio =
            ratio_of_peaks(scene, [&] { return stress_along(scene.model, b, way); });
        EXPECT_NEAR(ratio, decay(z), 1e-3) << z << ' ' << frame.angle;
      }
}

// A square has the same extents along both axes at every angle. If it is stressed alike
// in all directions, it has no shear strain in any frame.
TEST(VibrationDamping, OfASquareStressedOnAllSidesIsTheSameInEveryFrame) {
  for (const double poisson : {0.0, 0.25})
    for (const Frame& frame :
         {Frame{}, Frame{right_angle, {1000, 0}}, Frame{right_angle / 3, {-20, 5}}}) {
      const Material material = rock(poisson, 0.1);
      Scene scene = vibrating(frame, material);
      const int b = scene.box(-0.5, -0.5, 1, 1);
      scene.model.blocks.stress.col(b) << 1.0, 0.0, 0.0, 1.0;
      const auto stress = [&] { return stress_along(scene.model, b, {1, 0}); };
      const double stiffer = (material.c11() + material.c12()) / material.c11();
      EXPECT_NEAR(ratio_of_peaks(scene, stress), decay(0.1 / std::sqrt(stiffer)), 1e-3)
          << poisson << ' ' << frame.angle;
    }
}

// The stiffness of shear is C11 - C12, and the damping is that of C11.
TEST(VibrationDamping, DampsShearInEveryFrame) {
  const double z = 0.1 / std::sqrt(1.0 - 0.25 / 0.75);
  for (const double angle : {0.0, 0.4, 0.785398163397448}) {
    Scene scene = vibrating(Frame{angle, {0, 0}}, rock(0.25, 0.1));
    const int b = scene.box(-0.5, -0.5, 1, 1);
    const double c = std::cos(2 * angle), s = std::sin(2 * angle);
    scene.model.blocks.stress.col(b) << -s, c, c, s;
    const double ratio = ratio_of_peaks(scene, [&] {
      const auto now = scene.model.blocks.stress.col(b);
      return c * now[1] + s * 0.5 * (now[3] - now[0]);
    });
    EXPECT_NEAR(ratio, decay(z), 0.01) << angle;
  }
}

TEST(VibrationDamping, LeavesTheMotionOfTheWholeBlockAlone) {
  Scene scene = vibrating({}, rock(0.25, 1.0));
  const int b = scene.box(-0.5, -0.5, 1, 1);
  scene.velocity(b, 3, -4);
  scene.steps(1000);
  EXPECT_EQ(scene.velocity(b), Vec2(3, -4));

  Scene spinning = vibrating({}, rock(0.25, 1.0));
  const int s = spinning.box(-0.5, -0.5, 1, 1);
  spinning.velocity(s, 0, 0, 5.0);
  spinning.steps(1000);
  EXPECT_EQ(spinning.model.blocks.spin[s], 5.0);
}

/// Returns the largest deviation of the stress from that of equilibrium under a sudden
/// pressure of 1 on all sides, in each of `spans` spans of 200 steps.
std::vector<double> deviations(Scene& scene, int b, int spans) {
  for (int side = 0; side < 4; ++side)
    scene.model.loads.pressures.push_back({b, side, 1.0, 1.0, 0.0});
  scene.model.loads.function = {{0.0, 1.0}, {1.0, 1.0}};
  scene.prepare();
  EXPECT_TRUE(scene.model.time_step.elastic);
  std::vector<double> found;
  for (int span = 0; span < spans; ++span) {
    double max = 0.0;
    for (int i = 0; i < 200; ++i) {
      scene.step();
      const auto s = scene.model.blocks.stress.col(b);
      max = std::max({max, std::abs(s[0] + 1.0), std::abs(s[3] + 1.0)});
    }
    found.push_back(max);
  }
  return found;
}

// FRACTION is large, so the stiffness of the block chooses the time step. Twice that
// step would be unstable for a square with z = 0.75 and Poisson's ratio 0.25.
TEST(VibrationDamping, DecaysWithTheTimeStepOfTheStiffness) {
  for (const double z : {0.1, 0.5, 0.75, 1.0})
    for (const double poisson : {0.0, 0.25, 0.49})
      for (const double angle : {0.0, 0.3})
        for (const double length : {1.0, 4.0}) {
          Scene scene(Frame{angle, {0, 0}});
          scene.model.settings.rigid = false;
          scene.model.settings.fraction = 1.0;
          scene.model.settings.materials[1] = rock(poisson, z);
          const int b = scene.box(0, 0, length, 1);
          const auto found = deviations(scene, b, 4);
          EXPECT_LE(found.front(), 1.5) << z << ' ' << poisson << ' ' << length;
          // A block at an angle also vibrates in shear, which is not damped as such.
          if (angle == 0.0) {
            EXPECT_LT(found.back(), 1e-2) << z << ' ' << poisson << ' ' << length;
          } else {
            EXPECT_LE(found.back(), found.front()) << z << ' ' << poisson;
          }
        }
}

// Half of what is stable without damping is left to contacts, whatever z is.
TEST(VibrationDamping, ShortensTheTimeStep) {
  double undamped = 0.0;
  for (const double z : {0.0, 0.75, 1.0}) {
    Scene scene;
    scene.model.settings.rigid = false;
    scene.model.settings.fraction = 1.0;
    scene.model.settings.materials[1].damping = z;
    scene.box(0, 0, 2, 0.5);
    scene.prepare();
    if (z == 0.0)
      undamped = scene.dt();
    EXPECT_DOUBLE_EQ(scene.dt(), (std::sqrt(1.0 + z * z) - z) * undamped);
  }
}

TEST(VibrationDamping, PutsAllEnergyOfVibrationIntoTheAccount) {
  Scene scene = vibrating({}, rock(0.25, 0.1));
  const int b = scene.box(-0.5, -0.5, 1, 1);
  scene.model.blocks.stress.col(b) << 1e6, 0.0, 0.0, 0.0;
  scene.model.history.quantities = {"energy:artificial"};
  scene.run(0.02);
  const EnergyAccount& energy = scene.model.energy;
  EXPECT_GT(energy.start, 1.0);
  EXPECT_NEAR(energy.of(EnergyEntry::artificial), energy.start, 1e-3 * energy.start);
  EXPECT_LE(std::abs(energy.residual()), 1e-12 * energy.at_play());
}

/// Returns a damped pile of two materials on a floor, which is dropped. Only the second
/// material has `vibration`.
Scene pile(double vibration, double local, bool kinetic, int threads = 1) {
  Scene scene({0.3, {10, 20}}, threads);
  Settings& s = scene.model.settings;
  s.rigid = false;
  s.normal_stiffness = s.shear_stiffness = 1e9;
  s.fraction = 0.05, s.friction = 0.5;
  s.local_damping = local, s.kinetic_damping = kinetic;
  s.materials[1] = rock(0.25, 0.0);
  s.materials[2] = rock(0.1, vibration);
  scene.box(-2, -1, 20, 1, true);
  for (int row = 0; row < 8; ++row)
    for (int i = 0; i < 16; ++i) {
      const int b = scene.box(i + 0.3 * (row % 2), 1.0001 * row, 0.98, 1);
      scene.model.blocks.material[b] = 1 + (i + row) % 3 % 2;
      scene.velocity(b, 0.0, -1.0);
    }
  scene.gravity(0.5, -10);
  scene.model.history.quantities = {"energy:residual"};
  return scene;
}

TEST(VibrationDamping, ClosesTheEnergyAccountAloneAndWithOtherDamping) {
  double without[2][2] = {};
  for (const double z : {0.0, 0.3})
    for (const double local : {0.0, 0.5})
      for (const bool kinetic : {false, true}) {
        Scene scene = pile(z, local, kinetic);
        scene.steps(600);
        const EnergyAccount& energy = scene.model.energy;
        const double taken = energy.of(EnergyEntry::artificial);
        EXPECT_LE(std::abs(energy.residual()), 1e-12 * energy.at_play())
            << z << ' ' << local << ' ' << kinetic;
        double& other = without[local > 0.0][kinetic];
        if (z == 0.0) {
          other = taken;
        } else if (!kinetic) {
          EXPECT_GT(taken, other + 1e-3 * energy.at_play()) << local;
        }
      }
}

TEST(VibrationDamping, GivesTheSameBitsWithAnyNumberOfThreads) {
  Scene one = pile(0.3, 0.5, true);
  one.steps(200);
  Scene undamped = pile(0.0, 0.5, true);
  undamped.steps(200);
  EXPECT_NE(fields(undamped.model), fields(one.model));
  for (const int threads : {2, 5}) {
    Scene many = pile(0.3, 0.5, true, threads);
    many.steps(200);
    ASSERT_EQ(fields(many.model), fields(one.model)) << threads;
    ASSERT_EQ(many.model.energy.sums, one.model.energy.sums) << threads;
  }
}

}  // namespace
}  // namespace blocks
