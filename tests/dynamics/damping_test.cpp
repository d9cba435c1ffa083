// Local damping, kinetic damping and the ramp of gravity (docs/rest.md): what they do,
// where their energy goes, and the same bits however the steps are made.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/stepper.hpp"
#include "scenes/scene.hpp"
#include "tools/fields.hpp"

namespace blocks {
namespace {

using samples::fields;
using scenes::Frame;
using scenes::Scene;

TEST(LocalDamping, SlowsAFallByItsFactorInEveryFrame) {
  for (const Frame& frame : scenes::random_frames(4)) {
    Scene scene(frame);
    const int b = scene.box(-0.5, -0.5, 1, 2);
    scene.gravity(0, -10);
    scene.model.settings.local_damping = 0.8;
    const Vec2 start = scene.centroid(b);
    scene.steps(1000);
    const double t = 1000 * scene.dt();
    const Vec2 fell = scene.centroid(b) - start;
    // The first step has no velocity to oppose, so it is not damped.
    EXPECT_NEAR(fell.y(), -0.5 * 2 * t * t, 10 * t * scene.dt());
    EXPECT_NEAR(fell.x(), 0.0, 1e-8 * std::abs(fell.y()));
  }
}

// The damping of each axis by itself would turn the path of a thrown block.
TEST(LocalDamping, OpposesTheVelocityNotItsComponents) {
  Scene scene;
  const int b = scene.box(-0.5, -0.5, 1, 1);
  scene.gravity(0, -10);
  scene.velocity(b, 3, 4);
  scene.model.settings.local_damping = 0.5;
  scene.steps(1);
  const double dt = scene.dt();
  EXPECT_NEAR(scene.velocity(b).x(), 3 - dt * 0.5 * 10 * 0.6, 1e-12);
  EXPECT_NEAR(scene.velocity(b).y(), 4 - dt * (10 + 0.5 * 10 * 0.8), 1e-12);
}

TEST(GravityRamp, AddsGravityLinearlyFromTheStartOfEachStep) {
  Scene scene;
  const int b = scene.box(-0.5, -0.5, 1, 1);
  scene.prepare();
  const double dt = scene.dt();
  scene.gravity(0, -10);
  scene.model.settings.gravity_ramp = {{4, 0}, 0.0, 8 * dt};
  Vec2 velocity = Vec2::Zero();
  for (int i = 0; i < 12; ++i) {
    const double share = std::min(1.0, i / 8.0);
    velocity += dt * ((1 - share) * Vec2(4, 0) + share * Vec2(0, -10));
    scene.step();
    ASSERT_NEAR((scene.velocity(b) - velocity).norm(), 0.0, 1e-12) << i;
  }
}

TEST(KineticDamping, StopsBlocksAfterAPeakAndLosesNoMotionOfSprings) {
  Scene scene;
  scene.box(-5, -1, 10, 1, true);
  const int b = scene.box(0, 0, 1, 1);
  scene.gravity(0, -10);
  scene.model.settings.kinetic_damping = true;
  scene.run(0.5);
  const double depth = 2000 * 10 / 2e7;
  EXPECT_NEAR(scene.centroid(b).y(), 0.5 - depth, 1e-9 * depth);
  ASSERT_EQ(scene.model.contacts.size(), 2U);
  for (const Contact& contact : scene.model.contacts)
    EXPECT_NEAR(contact.normal_elastic, 1e7 * contact.overlap, 1e-9 * 1e4);
}

// The stiffness of the blocks sets the time step. If stopped blocks got the velocities
// of a whole step, their fast modes would grow from stop to stop.
TEST(KineticDamping, NeverAddsEnergyToDeformableBlocks) {
  Scene scene;
  Settings& s = scene.model.settings;
  s.rigid = false, s.fraction = 0.1;
  s.normal_stiffness = s.shear_stiffness = 1e9;
  s.materials[1] = {1e10, 4e9, 2500.0};
  scene.box(-2, -1, 4, 1, true);
  scene.box(-0.5, 0, 1, 1);
  scene.box(-0.5, 1, 1, 1);
  scene.gravity(0, -9.81);
  s.kinetic_damping = true;
  scene.model.history.quantities = {"energy:artificial"};
  scene.prepare();
  ASSERT_TRUE(scene.model.time_step.elastic);
  double before = 0.0;
  for (int i = 0; i < 4000; ++i) {
    ASSERT_TRUE(scene.step().finite);
    const double taken = scene.model.energy.of(EnergyEntry::artificial);
    EXPECT_GE(taken, before * (1.0 - 1e-12)) << i;
    before = taken;
  }
  EXPECT_LT(totals(scene.model).kinetic_energy, 1e-12 * before);
  EXPECT_LT(std::abs(scene.model.energy.residual()),
            1e-9 * scene.model.energy.at_play());
}

/// Returns leaning bricks on a floor, with an energy account. Gravity rises, and the
/// pile is damped.
Scene damped_heap(double local, bool kinetic, bool rigid, int threads = 1) {
  Scene scene({0.3, {10, 20}}, threads);
  Settings& s = scene.model.settings;
  s.rigid = rigid;
  s.friction = 0.5, s.damping = 0.1;
  s.local_damping = local, s.kinetic_damping = kinetic;
  scene.box(-2, -1, 20, 1, true);
  for (int row = 0; row < 8; ++row)
    for (int i = 0; i < 16; ++i) {
      const double lean = 0.05 * ((7 * i + 3 * row) % 5 - 2), y = 1.001 * row;
      const double x = i + 0.3 * (row % 2);
      scene.add({{x, y}, {x + lean, y + 1}, {x + 0.98 + lean, y + 1}, {x + 0.98, y}});
    }
  scene.gravity(0.5, -10);
  scene.model.history.quantities = {"energy:residual"};
  scene.prepare();
  s.gravity_ramp = {{0, 0}, 0.0, 100 * scene.dt()};
  return scene;
}

constexpr int steps = 300;

TEST(Damping, PutsItsEnergyIntoTheAccount) {
  for (const bool rigid : {true, false})
    for (const auto& [local, kinetic] :
         {std::pair(0.8, false), {0.0, true}, {0.5, true}}) {
      Scene scene = damped_heap(local, kinetic, rigid);
      scene.steps(4 * steps);  // the kinetic energy has its first peak
      const EnergyAccount& energy = scene.model.energy;
      EXPECT_GT(energy.of(EnergyEntry::gravity), 0.0);
      EXPECT_GT(energy.of(EnergyEntry::artificial), 0.02 * energy.at_play());
      EXPECT_LE(std::abs(energy.residual()), 1e-9 * energy.at_play())
          << local << kinetic << rigid;
    }
}

TEST(Damping, GivesTheSameBitsWithAnyNumberOfThreads) {
  for (const bool rigid : {true, false}) {
    Scene one = damped_heap(0.5, true, rigid);
    one.steps(steps);
    EXPECT_GT(totals(one.model).active_contacts, 100);
    for (const int threads : {2, 5}) {
      Scene many = damped_heap(0.5, true, rigid, threads);
      many.steps(steps);
      ASSERT_EQ(fields(many.model), fields(one.model)) << threads;
    }
  }
}

// Each step has a new stepper, which knows only the model, as after a checkpoint in the
// ramp.
TEST(Damping, ContinuesFromTheModelAloneInTheOrderOfItsSteps) {
  for (const bool rigid : {true, false}) {
    Model model = damped_heap(0.5, true, rigid).model;
    model.order = strip_order(model.blocks);
    Model straight = model;
    dynamics::Workspace work;
    dynamics::Stepper stepper(straight, work);
    for (int i = 1; i <= steps; ++i)
      stepper.advance(i == steps);
    stepper.up_to_date();
    for (int i = 1; i <= steps; ++i) {
      dynamics::Workspace other;
      dynamics::Stepper resumed(model, other);
      resumed.advance(i == steps);
      resumed.up_to_date();
    }
    EXPECT_EQ(fields(model), fields(straight));
  }
}

}  // namespace
}  // namespace blocks
