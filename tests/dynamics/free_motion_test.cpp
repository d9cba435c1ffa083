// Motion without contacts (docs/theory.md#motion).
#include <gtest/gtest.h>

#include "geometry/polygon.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Scene;

// The integrator gives v_n = n g dt and y_n = y_0 + n (n + 1) / 2 g dt^2.
TEST(FreeFall, IsTheSumOfTheIntegratorUpToRoundOff) {
  Scene scene;
  const int b = scene.box(0, 0, 1, 1);
  scene.gravity(0, -9.81);
  scene.velocity(b, 3, 0);
  scene.steps(1000);
  const double dt = scene.dt(), n = 1000;
  EXPECT_NEAR(scene.velocity(b).y(), -9.81 * dt * n, 1e-12 * 9.81 * dt * n);
  EXPECT_NEAR(scene.centroid(b).y(), 0.5 - 9.81 * dt * dt * n * (n + 1) / 2, 1e-12);
  EXPECT_NEAR(scene.centroid(b).x(), 0.5 + 3 * dt * n, 1e-12);
}

// The printed update (14) shears the block and makes it grow. The Cayley rotation keeps
// it rigid.
TEST(Spin, KeepsShapeAndSizeOverTenRadians) {
  Scene scene;
  const int b = scene.box(-0.5, -0.5, 2, 1);
  scene.velocity(b, 0, 0, 50.0);
  const auto before = geometry::section_properties(scene.model.blocks.outline(b));
  scene.run(0.25);
  const auto after = geometry::section_properties(scene.model.blocks.outline(b));
  EXPECT_GE(scene.model.blocks.angle[b], 10.0);
  EXPECT_NEAR(scene.model.blocks.angle[b], 50.0 * scene.model.time, 1e-11);
  EXPECT_NEAR(after.area, before.area, 1e-12);
  EXPECT_NEAR(after.polar_moment, before.polar_moment, 1e-12);
}

// The Cayley rotation turns by 2 atan(h), so the corners lag behind spin x time by the
// relative amount (spin dt)^2 / 12.
TEST(Spin, TurnsCornersByTheAccumulatedAngle) {
  Scene scene;
  const int b = scene.box(-0.5, -0.5, 1, 1);
  scene.velocity(b, 0, 0, 2.0);
  scene.run(0.5);
  const Vec2 arm = scene.model.blocks.present_arm(0);
  const double turned = std::atan2(arm.y(), arm.x()) - std::atan2(-0.5, -0.5);
  const double lag = std::pow(2.0 * scene.dt(), 2) / 12.0;
  EXPECT_NEAR(turned, 2.0 * scene.model.time,
              2.0 * lag * 2.0 * scene.model.time + 1e-12);
}

// Far from the origin a step of half a unit in the last place is rounded to a whole
// unit.
TEST(MotionBounds, AreNoLessThanTheMotion) {
  Scene scene;
  const double far = 0x1p30, unit = 0x1p-22;
  const int b = scene.box(far, 0, 1, 1);
  Blocks& blocks = scene.model.blocks;
  scene.model.settings.rigid = true;
  scene.velocity(b, 0.51 * unit, 0, 0);
  dynamics::MotionBounds bounds;
  bounds.start(blocks, true);
  double bound = 0.0;
  const double from = blocks.centroid(0, b);
  for (int i = 0; i < 1000; ++i)
    bound += dynamics::move_corners(blocks, dynamics::all_of(blocks), bounds,
                                    scene.model.settings, 1.0)
                 .bound;
  EXPECT_EQ(blocks.centroid(0, b) - from, 1000 * unit);
  EXPECT_GE(bound, 1000 * unit);
}

// A block is fixed if one of its corners is strictly outside. A corner on the border
// does not count.
TEST(Domain, FixesABlockThatLeaves) {
  Scene scene;
  scene.model.settings.lower = {0, 0};
  scene.model.settings.upper = {10, 10};
  const int stays = scene.box(0, 0, 1, 1), leaves = scene.box(8, 5, 1, 1);
  scene.velocity(leaves, 1, 0, 0);
  scene.run(1.5);
  EXPECT_TRUE(scene.model.blocks.is_free(stays));
  EXPECT_EQ(scene.model.blocks.fixity[leaves], Fixity::left_domain);
  EXPECT_EQ(scene.velocity(leaves), Vec2(0, 0));
  ASSERT_EQ(scene.model.exits.size(), 1U);
  EXPECT_NEAR(scene.model.exits[0].time, 1.0, 2 * scene.dt());
  EXPECT_NEAR(scene.centroid(leaves).x(), 9.5, 2 * scene.dt());
}

// A pressure from p1 to p2 over a side of length L gives the force L (p1 + p2) / 2.
TEST(Pressure, GivesForceMomentAndStress) {
  Scene scene;
  const int b = scene.box(0, 0, 3, 2);
  scene.model.loads.function = {{0, 1}, {1, 1}};  // These are times and factors.
  scene.model.loads.pressures.push_back(
      {b, 1, 100, 400, 0});  // The top side runs from (0, 2) to (3, 2).
  scene.steps(1);
  const Blocks& blocks = scene.model.blocks;
  EXPECT_NEAR(blocks.force(0, b), 0, 1e-12);
  EXPECT_NEAR(blocks.force(1, b), -750, 1e-10);
  // The moment about the middle of the side is (p2 - p1) L^2 / 12, clockwise.
  EXPECT_NEAR(blocks.moment[b], -225, 1e-10);
  EXPECT_NEAR(blocks.applied(3, b), -750.0 * 1.0 / 6.0, 1e-10);
  EXPECT_NEAR(blocks.area[b] * (blocks.applied(2, b) - blocks.applied(1, b)),
              blocks.moment[b], 1e-10);
}

// The factor of a force is 0 before its arrival time and f(t - arrival) afterwards.
// Forces on the same block add.
TEST(Force, ActsAtTheCentroidFromItsArrivalTime) {
  Scene scene;
  const int b = scene.box(0, 0, 1, 1);
  scene.model.loads.function = {{0, 0.01}, {1, 3}};
  scene.model.loads.forces.push_back({b, {10, 0}, 0.02});
  scene.model.loads.forces.push_back({b, {0, 5}, 0.02});
  scene.run(0.019);
  EXPECT_EQ(scene.velocity(b), Vec2(0, 0));
  scene.run(0.04);
  EXPECT_NEAR(scene.model.blocks.force(0, b), 30, 1e-9);
  EXPECT_NEAR(scene.model.blocks.force(1, b), 15, 1e-9);
  EXPECT_EQ(scene.model.blocks.spin[b], 0.0);
}

// Decks of 1982 may give a load that acts at once.
TEST(TimeFunction, StepsAtEqualTimes) {
  const TimeFunction f{{1, 2, 2, 4}, {10, 20, 50, 0}};
  EXPECT_EQ(f.factor(1.5, 0.0), 15.0);
  EXPECT_LT(f.factor(std::nextafter(2.0, 0.0), 0.0), 20.0 + 1e-12);
  EXPECT_EQ(f.factor(2.0, 0.0), 50.0);
  EXPECT_EQ(f.factor(3.0, 0.0), 25.0);
  const TimeFunction at_start{{0, 0}, {0, 1}};
  EXPECT_EQ(at_start.factor(0.0, 0.0), 1.0);
}

TEST(TimeFunction, IsLinearAndConstantBeyondItsEnds) {
  const TimeFunction f{{1, 2, 4}, {10, 20, 0}};
  EXPECT_EQ(f.factor(0.5, 1.0), 0.0);
  EXPECT_EQ(f.factor(1.5, 1.0), 10.0);
  EXPECT_EQ(f.factor(2.5, 1.0), 15.0);
  EXPECT_EQ(f.factor(4.0, 1.0), 10.0);
  EXPECT_EQ(f.factor(9.0, 1.0), 0.0);
}

}  // namespace
}  // namespace blocks
