// SERVO: a driven side that holds a normal stress (docs/rest.md#servos).
#include "dynamics/servo.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/stepper.hpp"
#include "model/drives.hpp"
#include "model/removal.hpp"
#include "scenes/joint_law.hpp"
#include "scenes/scene.hpp"
#include "tools/fields.hpp"

namespace blocks {
namespace {

using samples::fields;
using scenes::Frame;
using scenes::Scene;

const auto& frames = scenes::three_frames;
constexpr int bottom = 3, left = 0;  // sides of Scene::box, from 0

/// Returns the normal stress on the bottom of a box of width 2, tension positive.
double stress(const Scene& scene, const Frame& frame, int b) {
  return -frame.back(scene.model.blocks.force.col(b)).y() / 2.0;
}

/// Returns the stress that the springs of a plate of 2 m on a block carry.
double springs(const Scene& scene) {
  double sum = 0.0;
  for (const Contact& contact : scene.model.contacts)
    sum += contact.normal_elastic;
  return -sum / 2.0;
}

/// A plate of 2 m that a servo presses on a fixed block. It begins with a gap of 1 mm.
Scene plate(const Frame& frame, bool rigid, const JointLaw* law = nullptr,
            double target = -1e5, double damping = 0.0) {
  Scene scene(frame);
  scene.model.settings.rigid = rigid;
  scene.model.settings.damping = damping;
  if (law != nullptr)
    scenes::use_law(scene, *law);
  scene.box(-4, -1, 8, 1, true);
  scene.box(-1, 0.001, 2, 1, true);
  start_servo(scene.model, {1, bottom, target, 0.5});
  scene.prepare();
  return scene;
}

/// Makes steps until the plate is pressed on, and then lifts the limit of its speed.
void touch(Scene& scene) {
  for (int i = 0; i < 2000 && !(springs(scene) < -0.3e5); ++i)
    scene.step();
  scene.model.servos[0].max_speed = 100.0;
  scene.step();
}

TEST(Servo, ReducesItsErrorGeometricallyOnAFixedBlock) {
  for (const bool rigid : {true, false})
    for (const double damping : {0.0, 0.3})
      for (const Frame& frame : frames) {
        Scene scene = plate(frame, rigid, nullptr, -1e5, damping);
        scene.step();
        EXPECT_NEAR(scene.velocity(1).y(), -0.5, 1e-12) << "it approaches at vmax";
        touch(scene);
        double error = springs(scene) + 1e5;
        ASSERT_GT(error, 2e4);
        for (int i = 0; i < 12; ++i) {
          scene.step();
          const double next = springs(scene) + 1e5;
          EXPECT_NEAR(next / error, 1.0 - dynamics::servo_gain, 1e-6);
          error = next;
        }
        scene.steps(100);
        EXPECT_NEAR(stress(scene, frame, 1), -1e5, 1e-9 * 1e5);
      }
}

// After INSITU a contact of STIFF that has taken over another one is twice as stiff.
TEST(Servo, CountsTheStiffnessesThatContactsKeepAfterInsitu) {
  Scene scene = plate({}, true);
  touch(scene);
  Model& model = scene.model;
  model.settings.in_situ = true;
  model.law_states.resize(model.contacts.size());
  for (LawState& state : model.law_states) {
    state.stiffness = state.shear_stiffness = 2.0 * model.settings.normal_stiffness;
    state.failed = true;
  }
  dynamics::Workspace work;
  dynamics::Stepper stepper(model, work);
  model.servos[0].target = -2e5;
  stepper.advance(true);
  double error = springs(scene) + 2e5;
  ASSERT_GT(error, 1e4);
  for (int i = 0; i < 8; ++i) {
    stepper.advance(true);
    const double next = springs(scene) + 2e5;
    EXPECT_NEAR(next / error, 1.0 - dynamics::servo_gain, 1e-6);
    error = next;
  }
}

// The wedge is pressed into a groove with friction at its sides, so shear springs carry
// a part of the load.
TEST(Servo, CountsTheSpringsOfInclinedContacts) {
  for (const bool rigid : {true, false})
    for (const Frame& frame : frames) {
      Scene scene(frame);
      scene.model.settings.rigid = rigid;
      scene.model.settings.friction = 0.3;
      scene.add({{-3, -1}, {-3, 2}, {-2, 2}, {0, 0}, {2, 2}, {3, 2}, {3, -1}}, true);
      scene.add({{-0.5, 0.501}, {-1.5, 1.501}, {1.5, 1.501}, {0.5, 0.501}}, true);
      start_servo(scene.model, {1, bottom, -1e5, 0.5});
      scene.steps(1000);
      EXPECT_NEAR(frame.back(scene.model.blocks.force.col(1)).y(), 1e5, 1e-6);
      const auto shear_of = [](const Contact& contact) {
        return std::abs(contact.shear_elastic);
      };
      ASSERT_GE(scene.model.contacts.size(), 2U);
      EXPECT_GT(shear_of(scene.model.contacts[0]), 5e3);
    }
}

/// A joint with the closure of Bandis.
JointLaw rough() {
  JointLaw law;
  law.kind = LawKind::barton;
  law.roughness = 10, law.wall_strength = 1e8, law.residual_angle = 30;
  law.peak_slip = 0.004, law.initial_stiffness = 1e8, law.largest_closure = 2e-4;
  law.largest_stiffness = 1e11, law.shear_stiffness = 1e9;
  return law;
}

JointLaw hysteretic() {
  JointLaw law;
  law.kind = LawKind::walton;
  law.restitution = 0.25, law.normal_stiffness = law.shear_stiffness = 1e8;
  law.friction = law.residual_friction = 0.5;
  return law;
}

// The tangents of these laws change by a factor of up to 1000 and of 16.
TEST(Servo, DoesNotOvershootWithLawsThatStiffen) {
  for (const JointLaw& law : {rough(), hysteretic()})
    for (const Frame& frame : frames) {
      Scene scene = plate(frame, true, &law, -1e6);
      double lowest = 0.0;
      for (int i = 0; i < 20000; ++i) {
        scene.step();
        lowest = std::min(lowest, stress(scene, frame, 1));
        if (stress(scene, frame, 1) != 0.0)  // It has approached slowly.
          scene.model.servos[0].max_speed = 1e3;
      }
      EXPECT_NEAR(stress(scene, frame, 1), -1e6, 1e-6 * 1e6);
      EXPECT_GT(lowest, -1e6 * (1 + 1e-6));
      // From above.
      scene.model.servos[0].target = -2e5;
      double highest = -1e6;
      for (int i = 0; i < 20000; ++i) {
        scene.step();
        highest = std::max(highest, stress(scene, frame, 1));
      }
      EXPECT_NEAR(stress(scene, frame, 1), -2e5, 1e-5 * 2e5);
      EXPECT_LT(highest, -2e5 * (1 - 1e-6));
    }
}

TEST(Servo, WaitsWithoutContactUnlessItIsToPress) {
  for (const double target : {0.0, 1e4}) {
    Scene scene = plate({}, true, nullptr, target);
    scene.steps(10);
    EXPECT_EQ(scene.velocity(1), Vec2(0, 0));
  }
  Scene scene = plate({}, true);
  touch(scene);
  remove_blocks(scene.model, {0});
  dynamics::Workspace fresh;
  dynamics::step(scene.model, fresh);
  EXPECT_EQ(scene.velocity(1), Vec2(0, -100));
}

// A servo is a dashpot that pulls with a constant force, so it takes energy from a
// block that swings, whatever its mass.
TEST(Servo, HoldsItsStressOnFreeBlocks) {
  for (const bool rigid : {true, false})
    for (const double damping : {0.0, 0.3})
      for (const double thickness : {0.02, 1.0, 50.0})
        for (const Frame& frame : frames) {
          Scene scene(frame);
          scene.model.settings.rigid = rigid;
          scene.model.settings.damping = damping;
          scene.model.settings.fraction = 0.04;
          scene.model.settings.friction = 0.5;
          scene.model.settings.normal_stiffness = 1e8;
          scene.model.settings.shear_stiffness = 1e8;
          scene.box(-4, -1, 8, 1, true);
          scene.box(-1, 0, 2, thickness);
          scene.box(-1, thickness, 2, 1, true);
          start_servo(scene.model, {2, bottom, -1e4, 1e-3});
          scene.prepare();
          // Dashpots add to the force in proportion to the speed.
          const double vmax = damping == 0.0 ? 10.0 : 0.01;
          const double impact = vmax * std::sqrt(2e8 * scene.model.blocks.mass[1]);
          const double bound = damping == 0.0 ? 1.2e4 : 1.2e4 + impact;
          double worst = 0.0;
          const int steps = 40000;
          for (int i = 0; i < steps; ++i) {
            scene.step();
            worst = std::max(worst, std::abs(stress(scene, frame, 2) + 1e4));
            if (stress(scene, frame, 2) != 0.0)
              scene.model.servos[0].max_speed = vmax;
          }
          EXPECT_NEAR(stress(scene, frame, 2), -1e4, 0.02 * 1e4)
              << rigid << ' ' << damping << ' ' << thickness;
          EXPECT_LT(worst, bound) << rigid << ' ' << damping << ' ' << thickness;
        }
}

TEST(Servo, KeepsTheEnergyAccountClosed) {
  for (const bool rigid : {true, false})
    for (const Frame& frame : frames) {
      Scene scene(frame);
      scene.model.settings.rigid = rigid;
      scene.model.settings.damping = 0.1;
      scene.model.history.quantities = {"energy:residual"};
      scene.box(-4, -1, 8, 1, true);
      scene.box(-1, 0, 2, 1);
      scene.box(-1, 1.001, 2, 1, true);
      start_servo(scene.model, {2, bottom, -1e4, 0.2});
      scene.steps(2000);
      const EnergyAccount& energy = scene.model.energy;
      EXPECT_GT(energy.of(EnergyEntry::drives), 0.0);
      EXPECT_GT(energy.at_play(), 1e-3);
      EXPECT_LE(std::abs(energy.residual()), 1e-9 * energy.at_play());
    }
}

/// Returns a model with an internal order: two servos press bricks from above and from
/// the right.
Model pressed_bricks() {
  Scene scene;
  scene.model.settings.friction = 0.3;
  scene.model.settings.damping = 0.1;
  scenes::use_law(scene, scenes::cohesive());
  scene.box(-4, -1, 8, 1, true);
  scene.box(-1.6, 0, 0.5, 2, true);
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < 2; ++i)
      scene.box(-1 + i, row, 1, 1);
  scene.box(-1, 2.001, 2, 1, true);
  scene.box(1.002, 0.01, 0.5, 1.9, true);
  start_servo(scene.model, {6, bottom, -1e5, 0.2});
  start_servo(scene.model, {7, left, -4e4, 0.2});
  scene.prepare();
  scene.model.order = {7, 4, 2, 6, 3, 0, 1, 5};
  return scene.model;
}

TEST(Servo, HasTheSameBitsInARunThatIsContinuedFromTheModel) {
  constexpr int steps = 2000;
  Model straight = pressed_bricks();
  dynamics::Workspace work;
  dynamics::Stepper all(straight, work);
  for (int i = 1; i <= steps; ++i)
    all.advance(i == steps);
  all.up_to_date();
  EXPECT_NEAR(straight.blocks.force(1, 6), 2e5, 0.2 * 2e5);

  Model parts = pressed_bricks();
  for (int i = 1; i <= steps; ++i) {
    dynamics::Workspace its_own(1 + i % 3);
    dynamics::Stepper one(parts, its_own);
    one.advance(i == steps);
    one.up_to_date();
  }
  EXPECT_EQ(fields(parts), fields(straight));
}

TEST(Servo, EndsWithItsDrive) {
  const auto fresh = [] {
    Scene scene = plate({}, true);
    EXPECT_EQ(scene.model.servos.size(), 1U);
    return scene;
  };
  Scene driven = fresh();
  drive_block(driven.model, {1, {1, 0}, 0.0});
  EXPECT_TRUE(driven.model.servos.empty());
  EXPECT_EQ(driven.model.drives.size(), 1U);
  Scene removed = fresh();
  remove_blocks(removed.model, {1});
  EXPECT_TRUE(removed.model.servos.empty());
  Scene freed = fresh();
  free_blocks(freed.model, {1});
  EXPECT_TRUE(freed.model.servos.empty());
  EXPECT_TRUE(freed.model.drives.empty());
  Scene replaced = fresh();
  start_servo(replaced.model, {1, 1, -5.0, 2.0});
  ASSERT_EQ(replaced.model.servos.size(), 1U);
  EXPECT_EQ(replaced.model.servos[0].target, -5.0);
  EXPECT_EQ(replaced.model.drives.size(), 1U);
}

}  // namespace
}  // namespace blocks
