// Driven blocks: fixed blocks that move at a given velocity (DRIVE).
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/preparation/time_step.hpp"
#include "dynamics/stepper.hpp"
#include "model/drives.hpp"
#include "model/removal.hpp"
#include "scenes/scene.hpp"
#include "tools/fields.hpp"

namespace blocks {
namespace {

using samples::fields;
using scenes::Frame;
using scenes::Scene;

const Frame frames[] = {{}, {0.7, {3, -2}}, {-2.2, {1000, 500}}};

void drive(Scene& scene, const Frame& frame, int b, const Vec2& velocity,
           double spin = 0.0) {
  drive_block(scene.model, {b, frame.turn(velocity), spin});
}

// The weight of the box above does not stop the block.
TEST(DrivenBlock, MovesAtItsVelocityWhateverPushesIt) {
  for (const bool rigid : {true, false})
    for (const Frame& frame : frames) {
      Scene scene(frame);
      scene.model.settings.rigid = rigid;
      scene.box(0, 0, 4, 1, true);
      scene.box(1, 1, 1, 1);
      scene.box(-9, 0, 1, 1, true);
      scene.gravity(0, -10);
      const auto still = scene.model.blocks.corner.rightCols(4).eval();
      drive(scene, frame, 0, {0.5, 0.25});
      scene.steps(500);
      const double time = 500 * scene.dt(), size = 1.0 + frame.offset.norm();
      EXPECT_LT((scene.centroid(0) - Vec2(2 + 0.5 * time, 0.5 + 0.25 * time)).norm(),
                1e-13 * size * 500);
      EXPECT_EQ(scene.model.blocks.velocity.col(0), frame.turn({0.5, 0.25}));
      EXPECT_EQ(scene.model.blocks.angle[0], 0.0);
      EXPECT_TRUE(scene.model.blocks.is_driven(0));
      EXPECT_EQ(scene.model.blocks.corner.rightCols(4), still);
      EXPECT_GT(scene.centroid(1).y(), 1.5);  // it is lifted
    }
}

TEST(DrivenBlock, TurnsAboutItsCentroid) {
  for (const bool rigid : {true, false})
    for (const Frame& frame : frames) {
      Scene scene(frame);
      scene.model.settings.rigid = rigid;
      scene.box(-2, -1, 4, 2, true);
      scene.box(50, 0, 1, 1);
      drive(scene, frame, 0, {0, 0}, 2.0);
      scene.steps(1000);
      const Blocks& blocks = scene.model.blocks;
      const double angle = 2.0 * 1000 * scene.dt();
      EXPECT_NEAR(blocks.angle[0], angle, 1e-12);
      EXPECT_LT(scene.centroid(0).norm(), 1e-10);
      // The Cayley rotation turns by less than spin dt, by a third of its square.
      const double turned = 2000.0 * std::atan(scene.dt());
      const Vec2 corner = frame.back(Vec2(blocks.corner.col(0)) - frame.offset),
                 made(-2, -1);
      EXPECT_LT((corner - Frame{turned, Vec2::Zero()}.turn(made)).norm(), 1e-9);
    }
}

// A belt under a box: friction gives the box mu g until it has the speed of the belt.
TEST(DrivenBlock, DragsABoxByFriction) {
  for (const Frame& frame : frames) {
    Scene scene(frame);
    scene.model.settings.friction = 0.4;
    scene.model.settings.damping = 0.3;
    scene.box(-20, -1, 40, 1, true);
    scene.box(-1, 0, 2, 0.5);
    scene.gravity(0, -10);
    scene.run(1.0);  // it comes to rest
    drive(scene, frame, 0, {2.0, 0});
    scene.run(0.25);
    EXPECT_NEAR(scene.velocity(1).x(), 0.4 * 10 * 0.25, 0.01);
    EXPECT_NEAR(frame.back(scene.model.blocks.force.col(0)).x(), -0.4 * scene.weight(1),
                0.01 * scene.weight(1));
    scene.run(1.0);
    EXPECT_NEAR(scene.velocity(1).x(), 2.0, 1e-3);
    drive(scene, frame, 0, {0, 0});
    EXPECT_EQ(scene.model.drives.size(), 1U) << "it is held";
    const Vec2 stop = scene.centroid(0);
    scene.run(1.0);
    EXPECT_EQ(scene.centroid(0), stop);
    EXPECT_NEAR(scene.velocity(1).x(), 0.0, 1e-3);
  }
}

TEST(DrivenBlock, IsNotPartOfTheKineticEnergy) {
  Scene scene;
  scene.box(0, 0, 1, 1, true);
  scene.box(5, 0, 1, 1);
  drive(scene, {}, 0, {3, 4}, 1);
  EXPECT_EQ(totals(scene.model).kinetic_energy, 0.0);
  EXPECT_EQ(totals(scene.model).fastest, 0.0);
}

TEST(DrivenBlock, EndsWhenItIsRemovedOrFreed) {
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    scene.box(3 * i, 0, 1, 1, true);
    drive(scene, {}, i, {1, 0});
  }
  remove_blocks(scene.model, {0});
  free_blocks(scene.model, {2});
  ASSERT_EQ(scene.model.drives.size(), 1U);
  EXPECT_EQ(scene.model.drives[0].block, 1);
  EXPECT_EQ(scene.velocity(2), Vec2(1, 0));
}

/// Returns a model with an internal order, in which a driven block pushes two boxes and
/// leaves the domain before them.
Model pushed_out() {
  Scene scene;
  scene.model.settings.upper.x() = 9.99;
  scene.model.settings.friction = 0.1;
  scene.box(-20, -1, 29.9, 1, true);
  scene.box(0, 0, 1, 1), scene.box(1.2, 0, 1, 1);
  scene.add({{-1, 2.2}, {8.6, 2.2}, {8.6, 0.2}, {8.2, 0.2}, {8.2, 2}, {-1, 2}}, true);
  scene.box(-1.5, 0, 1, 1.5, true);
  scene.gravity(0, -10);
  drive(scene, {}, 3, {2, 0});
  drive(scene, {}, 4, {1.5, 0}, 0.1);
  scene.prepare();
  scene.model.order = {4, 2, 3, 0, 1};
  return scene.model;
}

TEST(DrivenBlock, HasTheSameBitsInARunThatIsContinuedFromTheModel) {
  constexpr int steps = 4000;
  Model straight = pushed_out();
  dynamics::Workspace work;
  dynamics::Stepper all(straight, work);
  for (int i = 1; i <= steps; ++i)
    all.advance(i == steps);
  all.up_to_date();
  ASSERT_EQ(straight.exits.size(), 1U);
  EXPECT_EQ(straight.exits[0].block, 3);
  ASSERT_EQ(straight.drives.size(), 1U);
  EXPECT_EQ(straight.drives[0].block, 4);
  EXPECT_EQ(straight.blocks.fixity[3], Fixity::left_domain);
  EXPECT_EQ(straight.blocks.velocity.col(3), Vec2(0, 0));
  EXPECT_GT(straight.blocks.centroid(0, 1), 1.0);  // it was pushed
  EXPECT_GT(straight.search.updates, 3);

  Model parts = pushed_out();
  for (int i = 1; i <= steps; ++i) {
    dynamics::Workspace its_own(1 + i % 2);
    dynamics::Stepper one(parts, its_own);
    one.advance(i == steps);
    one.up_to_date();
  }
  EXPECT_EQ(fields(parts), fields(straight));
}

// (4) with the stiffest contact that a law gives a block: half of its longest edge.
TEST(TimeStepOfLaws, TakesTheStiffestContact) {
  const auto chosen = [](const JointLaw& law, int id) {
    Scene scene;  // STIFF 1e7, FRACTION 0.02
    scene.box(0, 0, 2, 1, true);
    scene.box(0, 1, 2, 1);
    scene.model.blocks.joint.assign(8, id == 5 ? 5 : 0);
    scene.model.settings.joint_laws[id] = law;
    if (id == 6)
      scene.model.settings.joint_of_materials[{1, 1}] = 6;
    return dynamics::choose_time_step(scene.model).dt;
  };
  const auto critical = [](double stiffness) {
    return 0.02 * 2.0 * std::sqrt(2 * 1 * 2000.0 / stiffness);
  };
  JointLaw law;
  for (const int id : {5, 6, 7}) {  // by the sides, by the materials, nowhere
    const bool acts = id != 7;
    law = {};
    EXPECT_EQ(chosen(law, id), critical(1e7));
    law.normal_stiffness = 1e9, law.shear_stiffness = 4e9;
    EXPECT_EQ(chosen(law, id), critical(acts ? 4e9 : 1e7));
    law.shear_stiffness = 1e3;
    EXPECT_EQ(chosen(law, id), critical(acts ? 1e9 : 1e7));
    law.normal_stiffness = 1e3;
    EXPECT_EQ(chosen(law, id), critical(1e7));
    law.kind = LawKind::walton, law.restitution = 0.5;
    EXPECT_EQ(chosen(law, id), critical(acts ? 4e7 : 1e7));
    law.normal_stiffness = 1e9;
    EXPECT_EQ(chosen(law, id), critical(acts ? 4e9 : 1e7));
    law = {};
    law.kind = LawKind::barton, law.largest_stiffness = 5e8;
    EXPECT_EQ(chosen(law, id), critical(acts ? 5e8 : 1e7));
  }
}

}  // namespace
}  // namespace blocks
