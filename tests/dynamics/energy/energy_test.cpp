// The energy account closes, and each entry has the value that theory gives
// (docs/laws.md#energy).
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::Scene;

void keep_account(Scene& scene) {
  scene.model.history.quantities = {"energy:residual"};
}

void expect_closed(const Model& model) {
  const EnergyAccount& energy = model.energy;
  ASSERT_TRUE(energy.kept);
  EXPECT_GT(energy.at_play(), 0.0);
  EXPECT_LE(std::abs(energy.residual()), 1e-9 * energy.at_play());
}

double of(const Scene& scene, EnergyEntry entry) {
  return scene.model.energy.of(entry);
}

TEST(Energy, IsNotKeptUnlessAskedFor) {
  Scene scene;
  scene.box(0, 0, 1, 1);
  scene.gravity(0, -10);
  scene.run(0.1);
  EXPECT_FALSE(scene.model.energy.kept);
  EXPECT_TRUE(scene.model.energy.sums.empty());
}

TEST(Energy, OfFreeFlightIsKineticAndWorkOfGravity) {
  for (const Frame& frame : scenes::random_frames(4)) {
    Scene scene(frame);
    const int b = scene.box(-0.5, -0.5, 1, 2);
    scene.gravity(0, -10);
    scene.velocity(b, 3, 4, 2);
    keep_account(scene);
    scene.run(1.0);
    expect_closed(scene.model);
    // At the last force evaluation the block is one step behind, on its parabola.
    const double m = scene.model.blocks.mass[b], dt = scene.dt();
    const double start = 0.5 * (m * 25 + scene.model.blocks.inertia[b] * 4);
    EXPECT_NEAR(scene.model.energy.start, start, 1e-12 * start);
    EXPECT_NEAR(of(scene, EnergyEntry::gravity), m * -10 * (4 - 5),
                3 * m * 10 * 4 * dt);
    EXPECT_NEAR(of(scene, EnergyEntry::integration), -0.5 * m * 10 * 4 * dt,
                1e-9 * start);
  }
}

/// Drops a box on a floor without damping and returns the model after the time.
Model bounced(double fraction, double damping) {
  Scene scene(Frame{0.3, {1, 2}});
  scene.box(-5, -1, 10, 1, true);
  const int b = scene.box(0, 0.01, 1, 1);
  scene.velocity(b, 0.1, -1);
  scene.gravity(0, -10);
  scene.model.settings.friction = 0.3;
  scene.model.settings.damping = damping;
  scene.model.settings.fraction = fraction;
  keep_account(scene);
  scene.run(0.1);
  return scene.model;
}

TEST(Energy, OfABounceGoesToDashpotsAndErrorsVanishWithTheStep) {
  double last = INFINITY;
  for (const double fraction : {0.04, 0.01, 0.0025}) {
    const Model model = bounced(fraction, 0.2);
    expect_closed(model);
    const EnergyAccount& energy = model.energy;
    EXPECT_GT(energy.of(EnergyEntry::dashpots), 0.3 * energy.start);
    const double error = std::abs(energy.of(EnergyEntry::integration));
    EXPECT_LT(error, 0.4 * last);
    last = error;
  }
  EXPECT_LT(last, 0.002 * bounced(0.01, 0.2).energy.start);
}

// A symplectic step keeps the energy of a linear spring, if the kinetic energy is that
// of the velocities before and after the step.
TEST(Energy, OfAnOscillationIsExchangedWithTheSprings) {
  Scene scene;
  scene.box(-5, -1, 10, 1, true);
  const int b = scene.box(0, 0, 1, 1);
  scene.gravity(0, -10);
  scene.model.settings.fraction = 0.2;
  scene.model.settings.damping = 0.5;
  scene.run(2.0);
  keep_account(scene);
  scene.model.settings.damping = 0.0;
  scene.model.search.invalidate();  // the dashpots are made with the list
  scene.velocity(b, 0, -0.02);
  scene.steps(1);
  const double energy = 0.5 * scene.model.blocks.mass[b] * 0.02 * 0.02;
  const double error = of(scene, EnergyEntry::integration);
  const double at_rest = scene.model.energy.elastic;
  double max = 0.0;
  for (int i = 0; i < 1000; ++i) {
    scene.step();
    max = std::max(max, scene.model.energy.kinetic);
    EXPECT_NEAR(of(scene, EnergyEntry::integration), error, 1e-9 * energy) << i;
  }
  expect_closed(scene.model);
  EXPECT_NEAR(max, energy, 0.1 * energy);
  EXPECT_GT(at_rest, 0.0);
  EXPECT_EQ(of(scene, EnergyEntry::transfer), 0.0);
  EXPECT_NEAR(of(scene, EnergyEntry::dashpots), 0.0, 1e-12 * energy);
}

TEST(Energy, OfSlidingIsFrictionTimesTheDistance) {
  Scene scene(Frame{-0.5, {1000, 0}});
  scene.box(-50, -1, 100, 1, true);
  const int b = scene.box(-1, 0, 2, 1);
  scene.gravity(0, -10);
  scene.model.settings.friction = 0.5;
  scene.model.settings.damping = 0.5;
  keep_account(scene);
  scene.run(0.5);
  const double before = of(scene, EnergyEntry::friction), x0 = scene.centroid(b).x();
  scene.velocity(b, 2, 0);
  scene.run(0.3);
  expect_closed(scene.model);
  const double work = 0.5 * scene.weight(b) * (scene.centroid(b).x() - x0);
  EXPECT_NEAR(of(scene, EnergyEntry::friction) - before, work, 0.01 * work);
  // The card that gives a velocity adds energy.
  const double given = 0.5 * scene.model.blocks.mass[b] * 4;
  EXPECT_NEAR(-of(scene, EnergyEntry::removed), given, 1e-6 * given);
}

TEST(Energy, ClosesOnPlanesUnderPressureAndForces) {
  for (const bool rigid : {true, false}) {
    Scene scene(Frame{0.7, {-3, 5}});
    scene.model.settings.rigid = rigid;
    const int b = scene.box(0, 0, 2, 1);
    scene.plane({0, 0}, {10, 0});
    scene.gravity(0, -10);
    scene.model.settings.damping = 0.1;
    scene.model.loads.function = {{0, 0.01, 0.03}, {0, 1, 0.2}};
    scene.model.loads.pressures = {{b, 0, 1e5, 2e5, 0}, {b, 1, 1e5, 1e5, 0}};
    scene.model.loads.forces = {{b, Vec2(1e4, -1e4), 0.001}};
    keep_account(scene);
    scene.run(0.1);
    expect_closed(scene.model);
    EXPECT_GT(of(scene, EnergyEntry::loads), 0.0);
    EXPECT_GT(of(scene, EnergyEntry::dashpots), 0.0);
  }
}

TEST(Energy, ClosesInADeformableBarAndInASpinningBlock) {
  for (const double spin : {0.0, 5.0}) {
    Scene scene;
    Settings& settings = scene.model.settings;
    settings.rigid = false;
    settings.normal_stiffness = settings.shear_stiffness = 1e10;
    settings.materials.at(1) = {1e9, 4e8, 2000.0};
    settings.friction = 0.4;
    settings.damping = 0.02;
    for (int i = 0; i < 8; ++i) {
      const int b = scene.box(i + (i > 3 ? 0.001 : 0), 0, 1, 1);
      scene.velocity(b, i > 3 ? -10 : 10, 0, i == 7 ? spin : 0);
    }
    keep_account(scene);
    scene.run(0.02);
    expect_closed(scene.model);
    EXPECT_LT(std::abs(of(scene, EnergyEntry::integration)),
              0.01 * scene.model.energy.start);
  }
}

TEST(Energy, OfABlockThatLeavesTheDomainIsRemoved) {
  Scene scene;
  scene.model.settings.upper = {2, 2};
  const int b = scene.box(0, 0, 1, 1);
  scene.velocity(b, 10, 0);
  keep_account(scene);
  scene.run(0.2);
  expect_closed(scene.model);
  EXPECT_EQ(scene.model.energy.kinetic, 0.0);
  EXPECT_NEAR(of(scene, EnergyEntry::removed), 0.5 * 2000 * 100, 1e-6);
}

/// A heap that falls, tumbles, slides and comes to rest.
std::unique_ptr<Scene> heap(int threads) {
  auto scene = std::make_unique<Scene>(Frame{0.1, {10, 0}}, threads);
  scene->box(-10, -1, 20, 1, true);
  for (int i = 0; i < 60; ++i)
    scene->add({{i % 6 - 3.0, i / 6 * 1.2},
                {i % 6 - 2.9, i / 6 * 1.2 + 1},
                {i % 6 - 2.1, i / 6 * 1.2 + 0.9},
                {i % 6 - 2.2, i / 6 * 1.2 - 0.1}});
  scene->gravity(0, -10);
  scene->model.settings.friction = 0.4;
  scene->model.settings.damping = 0.2;
  keep_account(*scene);
  return scene;
}

TEST(Energy, HasTheSameBitsWithAnyThreadsAndAfterARestart) {
  const auto one = heap(1), two = heap(3);
  one->run(1.0);
  two->run(1.0);
  expect_closed(one->model);
  EXPECT_GT(of(*one, EnergyEntry::friction), 0.0);
  EXPECT_EQ(one->model.energy.sums, two->model.energy.sums);
  EXPECT_EQ(one->model.energy.errors, two->model.energy.errors);

  // A new workspace reads the contacts from the list, as a restart does.
  const auto again = heap(1);
  again->run(0.4);
  Model copy = again->model;
  dynamics::Workspace work(2);
  while (copy.steps < one->model.steps)
    dynamics::advance(copy, work, false);
  EXPECT_EQ(copy.energy.sums, one->model.energy.sums);
  EXPECT_EQ(copy.energy.errors, one->model.energy.errors);
  EXPECT_EQ(copy.energy.elastic, one->model.energy.elastic);
  EXPECT_EQ(copy.energy.kinetic, one->model.energy.kinetic);
}

}  // namespace
}  // namespace blocks
