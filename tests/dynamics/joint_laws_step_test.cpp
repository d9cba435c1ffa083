// Laws of joints within the time step: lengths, bonds, held contacts, restart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dynamics/kernels/kernels.hpp"
#include "dynamics/preparation/bond.hpp"
#include "dynamics/step.hpp"
#include "model/drives.hpp"
#include "scenes/joint_law.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::Scene;

using scenes::cohesive;
using scenes::heap;
using scenes::use_law;

const auto& frames = scenes::three_frames;

/// Returns the sum of the lengths of the contacts of two blocks.
double common_length(const Model& model, int a, int b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < model.contacts.size(); ++i)
    if (pair_of(model.blocks, model.contacts[i]) == std::minmax({a, b}))
      sum += model.law_states[i].length;
  return sum;
}

TEST(JointLaws, FrictionAloneHasTheBitsOfFrictn) {
  for (const bool rigid : {true, false}) {
    Scene plain = heap(rigid), with_law = heap(rigid);
    plain.model.settings.friction = 0.5;
    JointLaw law;
    law.friction = law.residual_friction = 0.5;
    use_law(with_law, law);
    plain.steps(2000), with_law.steps(2000);
    EXPECT_TRUE(plain.model.blocks.corner == with_law.model.blocks.corner);
    EXPECT_TRUE(plain.model.contacts == with_law.model.contacts);
    EXPECT_FALSE(with_law.model.law_states.empty());
  }
}

TEST(JointLaws, LengthsOfAlignedAndOffsetFacesAddUp) {
  for (const Frame& frame : frames)
    for (const double offset : {0.0, 0.3, -0.45, 1.2}) {
      Scene scene(frame);
      use_law(scene, cohesive());
      const int floor = scene.box(0, -1, 2, 1, true);
      const int brick = scene.box(offset, 0, 2, 1);
      scene.gravity(0, -10);
      ASSERT_EQ(dynamics::bond_faces(scene.model, 7, 1e-6), offset == 0.0 ? 4 : 2);
      scene.steps(1);
      EXPECT_NEAR(common_length(scene.model, floor, brick), 2.0 - std::abs(offset),
                  1e-9);
    }
}

TEST(JointLaws, BondedBrickHangsAndFallsWhenTheTensionIsTooLarge) {
  for (const Frame& frame : frames)
    for (const bool rigid : {true, false})
      for (const double strength : {0.98, 1.02}) {
        Scene scene(frame);
        scene.model.settings.rigid = rigid;
        JointLaw law = cohesive();
        law.tension = strength * 2000.0 * 10.0;  // weight of one metre of height
        use_law(scene, law);
        scene.model.settings.damping = 0.1;
        scene.box(0, 1, 2, 1, true);
        const int brick = scene.box(0, 0, 2, 1);
        dynamics::bond_faces(scene.model, 0, 1e-6);
        // The weight is put on slowly: a sudden load would need twice the strength.
        scene.prepare();
        const int steps = 20000;
        for (int i = 0; i < steps; ++i) {
          scene.gravity(0, -10.0 * std::min(1.0, 2.0 * i / steps));
          scene.step();
        }
        const double fall = -(scene.centroid(brick).y() - 0.5);
        if (strength > 1.0)
          EXPECT_NEAR(fall, 2000.0 * 2.0 * 10.0 / (1e9 * 2.0),
                      1e-7 + (rigid ? 0 : 1e-5));
        else
          EXPECT_GT(fall, 0.01);
      }
}

TEST(JointLaws, RestartInTheMiddleHasTheSameBits) {
  for (const bool rigid : {true, false}) {
    Scene through = heap(rigid);
    JointLaw law = cohesive();
    law.dilation = 0.2, law.dilation_limit = 0.003;
    use_law(through, law);
    through.model.blocks.joint.assign(through.model.blocks.joint.size(), 0);
    dynamics::bond_faces(through.model, 7, 0.06);
    through.steps(700);
    Scene again = heap(rigid);
    again.model = through.model;
    EXPECT_GT(std::count_if(again.model.law_states.begin(),
                            again.model.law_states.end(),
                            [](const LawState& state) { return state.offset > 0; }),
              0);
    through.steps(700), again.steps(700);
    EXPECT_TRUE(through.model.blocks.corner == again.model.blocks.corner);
    EXPECT_TRUE(through.model.contacts == again.model.contacts);
    EXPECT_TRUE(through.model.law_states == again.model.law_states);
  }
}

// A weakened contact has residual tension, but only where there is an edge.
TEST(JointLaws, WeakenedContactEndsBeyondItsEdge) {
  for (const Frame& frame : frames) {
    Scene scene(frame);
    JointLaw law;
    law.friction = law.residual_friction = 0.05;
    law.cohesion = law.residual_cohesion = 1e5;
    law.tension = law.residual_tension = 1.0;
    law.normal_stiffness = law.shear_stiffness = 1e9;
    use_law(scene, law);
    scene.box(0, -1, 2, 1, true);
    const int block = scene.box(0.5, 0, 1, 1);
    dynamics::bond_faces(scene.model, 0, 1e-6);
    scene.velocity(block, 20, 0);
    scene.gravity(0, -10);
    scene.run(0.4);
    EXPECT_LT(scene.centroid(block).y(), 0.2) << "it has slid off the table and falls";
  }
}

// A softer law does not soften contacts that act, so the time step must not grow.
TEST(JointLaws, TimeStepKnowsTheStiffnessesThatContactsKeep) {
  Scene scene;
  JointLaw law = cohesive();
  use_law(scene, law);
  scene.box(0, -1, 2, 1, true);
  scene.box(0, 0, 2, 1);
  dynamics::bond_faces(scene.model, 0, 1e-6);
  scene.gravity(0, -10);
  scene.steps(10);
  const double dt = scene.dt();
  law.normal_stiffness = law.shear_stiffness = 1e7;
  use_law(scene, law);
  scene.model.time_step.blocks = 0;
  scene.prepare();
  // They have half of the bound of a whole edge: two contacts at each end.
  EXPECT_NEAR(scene.dt() / dt, std::sqrt(2.0), 1e-12);
}

TEST(JointLaws, ThreadsDoNotChangeResults) {
  Scene one = heap(true, 1), three = heap(true, 3);
  for (Scene* scene : {&one, &three}) {
    JointLaw law = cohesive();
    law.dilation = 0.1;
    use_law(*scene, law);
    dynamics::bond_faces(scene->model, 7, 0.06);
    scene->steps(1000);
  }
  EXPECT_TRUE(one.model.blocks.corner == three.model.blocks.corner);
  EXPECT_TRUE(one.model.contacts == three.model.contacts);
  EXPECT_TRUE(one.model.law_states == three.model.law_states);
}

TEST(JointLaws, DrivenBlockActsOnFixedOne) {
  // Shear box: stress 1 MPa, cohesion 0.2 MPa, friction 0.5, 2 m long.
  for (const Frame& frame : frames) {
    Scene scene(frame);
    use_law(scene, cohesive());
    scene.box(-4, -1, 8, 1, true);
    const int upper = scene.box(-1, 0, 2, 1, true);
    const auto drive = [&](double vx, double vy) {
      drive_block(scene.model, {upper, frame.turn({vx, vy}), 0.0});
    };
    drive(0, 0);  // two fixed blocks have no contacts
    dynamics::bond_faces(scene.model, 7, 1e-6);
    scene.prepare();
    const int steps = static_cast<int>(0.01 / scene.dt() + 0.5);
    const double v = 1e-3 / (steps * scene.dt());
    drive(0, -v);
    scene.steps(steps + 1);  // forces are those at the start of a step
    const auto force = [&] { return frame.back(scene.model.blocks.force.col(upper)); };
    drive(0, 0);
    scene.steps(2);
    EXPECT_NEAR(force().y(), 2e6, 2e6 * (1.0 / steps + 1e-6));
    const double normal = force().y();
    drive(5e-3, 0);
    double peak = 0.0;
    for (int i = 0; i < 4000; ++i) {
      scene.step();
      peak = std::max(peak, -force().x());
    }
    EXPECT_NEAR(peak, 0.5 * normal + 4e5, 1e-3 * peak);
    EXPECT_NEAR(-force().x(), 0.5 * normal, 1e-3 * peak);
  }
}

}  // namespace
}  // namespace blocks
