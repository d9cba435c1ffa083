// Quiet sides: dashpots, the reaction that stays, and the energy that leaves (QUIET,
// docs/waves.md). Reflection is measured in validation/problems/quiet_sides.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/preparation/quiet.hpp"
#include "dynamics/stepper.hpp"
#include "model/drives.hpp"
#include "model/equilibrium.hpp"
#include "model/removal.hpp"
#include "scenes/scene.hpp"
#include "tools/fields.hpp"

namespace blocks {
namespace {

using dynamics::make_quiet;
using samples::fields;
using scenes::Frame;
using scenes::Scene;

const Frame frames[] = {{}, {0.7, {3, -2}}, {-2.2, {1000, 500}}};
constexpr double density = 2000.0;  // of the scenes
constexpr double cp = 300.0, cs = 200.0;

// Side 1 of a box is its left one, of length h. Its corners are below and above.
TEST(QuietSide, BrakesItsCornersByTheirVelocities) {
  for (const bool rigid : {true, false})
    for (const Frame& frame : frames) {
      Scene scene(frame);
      Model& model = scene.model;
      model.settings.rigid = rigid;
      const double w = 2.0, h = 0.5;
      scene.box(0, 0, w, h);
      make_quiet(model, {.block = 0, .side = 0, .cp = cp, .cs = cs});
      scene.velocity(0, 0.3, -0.2, 0.4);
      scene.prepare();
      const double dt = scene.dt(), mass = w * h * density;
      scene.step();
      const double half = 0.5 * density * h;
      double fx = 0.0, fy = 0.0, moment = 0.0;
      for (const double y : {-0.5 * h, 0.5 * h}) {
        const double x = -0.5 * w, vx = 0.3 - 0.4 * y, vy = -0.2 + 0.4 * x;
        fx -= half * cp * vx, fy -= half * cs * vy;
        moment += -x * half * cs * vy + y * half * cp * vx;
      }
      const double size = 1e-12 * (1.0 + frame.offset.norm());
      const Vec2 force = frame.back(Vec2(model.blocks.force.col(0)));
      EXPECT_NEAR(force.x(), fx, size * std::abs(fx));
      EXPECT_NEAR(force.y(), fy, size * std::abs(fy));
      EXPECT_NEAR(model.blocks.moment[0], moment, size * std::abs(moment));
      EXPECT_NEAR(scene.velocity(0).x(), 0.3 + dt * fx / mass, size);
    }
}

// A stretching block moves the corners of its side, and only that side is braked.
TEST(QuietSide, BrakesStrainRates) {
  Scene scene;
  scene.model.settings.rigid = false;
  scene.box(-1, -1, 2, 2);
  make_quiet(scene.model, {.block = 0, .side = 2, .cp = cp, .cs = cs});
  scene.model.blocks.strain_rate.col(0) = Eigen::Vector4d(0.01, 0, 0, 0);
  scene.steps(1);
  EXPECT_NEAR(scene.model.blocks.force(0, 0), -density * 2 * cp * 0.01, 1e-9);
  EXPECT_NEAR(scene.model.blocks.applied(0, 0), -density * 2 * cp * 0.01 / 4, 1e-9);
}

/// A leaning pile on a fixed block, at rest.
Scene resting(const Frame& frame, bool rigid) {
  Scene scene(frame);
  scene.model.settings.rigid = rigid;
  scene.model.settings.damping = 0.5;
  scene.model.settings.friction = 0.7;
  scene.box(0, 0, 2, 1, true);
  scene.box(0.3, 1, 1, 1);
  scene.box(0.1, 2, 1, 1);
  scene.gravity(0, -10);
  scene.run(8.0);
  return scene;
}

TEST(QuietSide, KeepsTheReactionThatHeldTheBlock) {
  for (const bool rigid : {true, false})
    for (const Frame& frame : frames) {
      Scene scene = resting(frame, rigid);
      Model& model = scene.model;
      const auto speed = [&] { return model.blocks.velocity.cwiseAbs().maxCoeff(); };
      const double before = speed(), all = 4 * density * 10;
      ASSERT_LT(before, 1e-6);
      const Vec2 held = frame.back(
          make_quiet(model, {.block = 0, .side = 3, .cp = 1000.0, .cs = 500.0}));
      EXPECT_TRUE(model.blocks.is_free(0));
      EXPECT_NEAR(held.x(), 0.0, 1e-5 * all);
      EXPECT_NEAR(held.y(), all, 1e-5 * all);
      const QuietSide& quiet = model.loads.quiet_sides.at(0);
      // The pile stands to the left of the middle. Side 4 begins at its right corner.
      EXPECT_GT(frame.back(quiet.second).y(), frame.back(quiet.first).y());
      EXPECT_LT((frame.turn(held) - quiet.first - quiet.second).norm(), 1e-9 * all);
      scene.steps(1);
      const Vec2 force(model.blocks.force.col(0));
      EXPECT_LT((force + frame.turn({0, -10 * 2 * density})).norm(), 1e-5 * all);
      EXPECT_LT(std::abs(model.blocks.moment[0]), 1e-5 * all);
      const auto out_of_balance = [&] {
        const auto applied = model.blocks.applied.col(0),
                   s = model.blocks.stress.col(0);
        return std::abs(applied[0] - s[0]) + std::abs(applied[3] - s[3]) +
               std::abs(0.5 * (applied[1] + applied[2]) - s[1]);
      };
      EXPECT_LT(rigid ? 0.0 : out_of_balance(), 1e-5 * all);
      scene.run(2.0);
      EXPECT_LT(speed(), 1e-5);
      EXPECT_LT(unbalanced_ratio(model), 1e-6);
      EXPECT_LT(rigid ? 0.0 : out_of_balance(), 1e-4 * all);
    }
}

TEST(QuietSide, OfAFreeBlockHasNoConstantForce) {
  Scene scene;
  scene.box(0, 0, 1, 1);
  scene.gravity(0, -10);
  EXPECT_EQ(make_quiet(scene.model, {.block = 0, .side = 1, .cp = 1, .cs = 1}),
            Vec2(0, 0));
  EXPECT_EQ(scene.model.loads.quiet_sides[0].first, Vec2(0, 0));
}

TEST(QuietSide, TakesNewSpeedsAndKeepsItsForces) {
  Scene scene;
  scene.box(0, 0, 1, 1, true);
  scene.gravity(0, -10);
  make_quiet(scene.model, {.block = 0, .side = 3, .cp = 30, .cs = 20});
  make_quiet(scene.model, {.block = 0, .side = 3, .cp = 3, .cs = 2});
  make_quiet(scene.model, {.block = 0, .side = 1, .cp = 5, .cs = 4});
  const std::vector<QuietSide>& sides = scene.model.loads.quiet_sides;
  ASSERT_EQ(sides.size(), 2U);
  EXPECT_EQ(sides[0].cp, 3.0);
  EXPECT_EQ(sides[0].cs, 2.0);
  EXPECT_EQ(sides[0].first, Vec2(0, 5 * density));
  EXPECT_EQ(sides[1].first, Vec2(0, 0));
}

TEST(QuietSide, EndsWhenItsBlockIsRemoved) {
  Scene scene;
  for (int i = 0; i < 2; ++i) {
    scene.box(3 * i, 0, 1, 1);
    make_quiet(scene.model, {.block = i, .side = 0, .cp = 1, .cs = 1});
  }
  remove_blocks(scene.model, {0});
  ASSERT_EQ(scene.model.loads.quiet_sides.size(), 1U);
  EXPECT_EQ(scene.model.loads.quiet_sides[0].block, 1);
}

// A moving box loses its energy through the dashpots, and the work of the constant
// forces is that of a load.
TEST(QuietSide, CarriesOffEnergyThatTheAccountKnows) {
  for (const bool rigid : {true, false})
    for (const Frame& frame : frames) {
      Scene scene = resting(frame, rigid);
      Model& model = scene.model;
      make_quiet(model, {.block = 0, .side = 3, .cp = 1000.0, .cs = 500.0});
      scene.velocity(0, 0.02, -0.01, 0.01);
      model.history.quantities = {"energy:residual"};
      scene.prepare();
      const double start = model.energy.kinetic;
      const Eigen::Matrix2Xd before = model.blocks.corner.leftCols(4);
      scene.run(0.1);
      const EnergyAccount& energy = model.energy;
      EXPECT_LE(std::abs(energy.residual()), 1e-9 * energy.at_play());
      EXPECT_GT(energy.of(EnergyEntry::quiet), 0.2 * start);
      // Side 4 joins corners 4 and 1.
      const QuietSide& quiet = model.loads.quiet_sides[0];
      const Eigen::Matrix2Xd moved = model.blocks.corner.leftCols(4) - before;
      const double work =
          quiet.first.dot(Vec2(moved.col(3))) + quiet.second.dot(Vec2(moved.col(0)));
      EXPECT_NEAR(energy.of(EnergyEntry::loads), work,
                  4 * density * 10 * 0.03 * scene.dt());
    }
}

// A drive does the work of the dashpots on its block.
TEST(QuietSide, OnADrivenBlockBrakesOnlyInTheAccount) {
  Scene scene;
  Model& model = scene.model;
  scene.box(0, 0, 2, 1);
  make_quiet(model, {.block = 0, .side = 3, .cp = cp, .cs = cs});
  model.blocks.fix(0, Fixity::by_user);
  drive_block(model, {0, {0.5, 0.25}, 0.0});
  model.history.quantities = {"energy:residual"};
  scene.steps(100);
  EXPECT_EQ(scene.velocity(0), Vec2(0.5, 0.25));
  const double power = density * 2 * (cs * 0.25 + cp * 0.0625);
  const double quiet = model.energy.of(EnergyEntry::quiet);
  EXPECT_NEAR(quiet, power * 100 * scene.dt(), 1e-9 * quiet);
  EXPECT_NEAR(model.energy.of(EnergyEntry::drives), quiet, 1e-12 * quiet);
}

// rho L cp / m = cp / w along the normal. The strain rate of the same corners has the
// same rate again, because the strain masses are at the corners.
TEST(QuietSide, DecaysAtTheRateOfItsDashpots) {
  for (const Frame& frame : {Frame{}, Frame{1.5707963267948966, {5, 5}}}) {
    Scene scene(frame);
    scene.box(0, 0, 0.5, 0.125);
    const std::vector<QuietSide> sides = {{0, 0, cp, 1e-9}, {1, 0, 1e9, 1e9}};
    const Blocks& blocks = scene.model.blocks;
    EXPECT_NEAR(dynamics::decay_rate(blocks, true, 0, sides), cp / 0.5, 1e-6);
    EXPECT_NEAR(dynamics::decay_rate(blocks, false, 0, sides), 2 * cp / 0.5, 1e-6);
  }
}

/// Returns a model with an internal order, in which boxes fall on a base with two quiet
/// sides.
Model shaken() {
  Scene scene;
  scene.model.settings.rigid = false;
  scene.model.settings.friction = 0.3;
  scene.box(0, 1.01, 1, 1), scene.box(1.2, 1.02, 1, 1);
  scene.box(0, 0, 3, 1, true);
  scene.box(0.2, 2.05, 1, 1);
  scene.gravity(0, -10);
  make_quiet(scene.model, {.block = 2, .side = 3, .cp = 300, .cs = 200});
  make_quiet(scene.model, {.block = 2, .side = 0, .cp = 300, .cs = 200});
  scene.model.history.quantities = {"energy:residual"};
  scene.prepare();
  scene.model.order = {2, 3, 0, 1};
  return scene.model;
}

TEST(QuietSide, HasTheSameBitsInARunThatIsContinuedFromTheModel) {
  constexpr int steps = 2000;
  Model straight = shaken();
  dynamics::Workspace work;
  dynamics::Stepper all(straight, work);
  for (int i = 1; i <= steps; ++i)
    all.advance(i == steps);
  all.up_to_date();
  EXPECT_GT(straight.energy.of(EnergyEntry::quiet), 0.0);
  EXPECT_GE(straight.contacts.size(), 3U);
  Model parts = shaken();
  for (int i = 1; i <= steps; ++i) {
    dynamics::Workspace its_own(1 + i % 2);
    dynamics::Stepper one(parts, its_own);
    one.advance(i == steps);
    one.up_to_date();
  }
  EXPECT_EQ(fields(parts), fields(straight));
}

}  // namespace
}  // namespace blocks
