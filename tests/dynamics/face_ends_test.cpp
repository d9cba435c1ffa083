// The contacts at an end of a face share its spring (docs/laws.md#length).
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "scenes/joint_law.hpp"
#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::Scene;

constexpr double degree = 0.017453292519943295;

/// Friction and stiffnesses per area.
JointLaw stiff(double friction, double stiffness) {
  JointLaw law;
  law.friction = law.residual_friction = friction;
  law.normal_stiffness = law.shear_stiffness = stiffness;
  return law;
}

/// What the contacts of two blocks carry together.
struct FaceSums {
  int contacts = 0;
  double normal = 0.0, shear = 0.0;  ///< [F]
  double stiffness = 0.0;            ///< [F/L]
};
FaceSums face_between(const Model& model, int a, int b) {
  FaceSums sums;
  for (std::size_t i = 0; i < model.contacts.size(); ++i)
    if (pair_of(model.blocks, model.contacts[i]) == std::minmax({a, b})) {
      ++sums.contacts;
      sums.normal += model.contacts[i].normal_elastic;
      sums.shear += model.contacts[i].shear_elastic;
      sums.stiffness += model.law_states[i].stiffness;
    }
  return sums;
}

// A block is pressed into a corner. One of its corners touches both faces, at the very
// end of one of them.
TEST(FaceEnds, ABlockInACornerCarriesTheSameInEveryFrame) {
  constexpr double kn = 4e9, pressure = 1e5;
  for (const double degrees : {0.0, 1e-10, 33.0, 45.0, 90.0, -120.0}) {
    Scene scene({degrees * degree, {0, 0}});
    use_law(scene, stiff(0.0, kn));
    scene.model.settings.damping = 0.3;
    const int floor = scene.box(-2, -0.5, 8, 0.5, true);
    const int wall = scene.box(2, 0, 0.5, 3, true);
    const int block = scene.box(0, 0, 2, 1);
    scene.model.loads.function = {{0.0, 0.05, 10.0}, {0.0, 1.0, 1.0}};
    scene.model.loads.pressures.push_back({block, 0, pressure, pressure, 0.0});
    scene.prepare();
    while (scene.model.time < 0.4) {
      scene.gravity(0, -10 * std::min(1.0, scene.model.time / 0.1));
      scene.step();
    }
    const FaceSums below = face_between(scene.model, floor, block);
    const FaceSums beside = face_between(scene.model, wall, block);
    EXPECT_NEAR(below.stiffness, 2 * kn, 1e-4 * kn) << degrees;
    EXPECT_NEAR(beside.stiffness, kn, 1e-4 * kn) << degrees;
    EXPECT_NEAR(below.normal, scene.weight(block), 1e-4 * scene.weight(block));
    EXPECT_NEAR(beside.normal, pressure, 1e-4 * pressure) << degrees;
    for (std::size_t i = 0; i < scene.model.contacts.size(); ++i) {
      const double share = scene.model.law_states[i].length;
      const double of =
          pair_of(scene.model.blocks, scene.model.contacts[i]).first == floor
              ? 0.5 * scene.weight(block)
              : pressure;
      EXPECT_NEAR(scene.model.contacts[i].normal_elastic, share * of, 1e-4 * of);
    }
  }
}

// The upper block moves a little to the left and to the right of the flush position, so
// each of two corners that meet acts and rests again and again.
TEST(FaceEnds, AFaceKeepsItsStiffnessAndForceWhicheverCornersAct) {
  constexpr double kn = 1e9;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int changes = 0;
  for (int k = 0; k < 60; ++k) {
    Scene scene({3.0 * any(random), {10 * any(random), 10 * any(random)}});
    scene.model.settings.rigid = k % 2 == 0;
    use_law(scene, stiff(0.5, kn));
    const int lower = scene.box(0, -1, 1, 1, true);
    const int upper = scene.box(0, 0, 1, 1);
    scene.gravity(0, -10);
    scene.model.settings.damping = 0.3;
    scene.steps(3000);  // comes to rest
    const double weight = scene.weight(upper);
    ASSERT_NEAR(face_between(scene.model, lower, upper).normal, weight, 1e-3 * weight);
    int before = face_between(scene.model, lower, upper).contacts;
    for (int i = 0; i < 400; ++i) {
      // At most 20 millionths of the side in a step; the slack is 4.
      const double step = 2e-5 * any(random), at = scene.centroid(upper).x() - 0.5;
      scene.velocity(upper, (step - 0.5 * at) / scene.dt(), 0.0);
      scene.step();
      const FaceSums face = face_between(scene.model, lower, upper);
      EXPECT_NEAR(face.stiffness, kn, 1e-4 * kn) << k << ' ' << i;
      EXPECT_NEAR(face.normal, weight, 2e-2 * weight) << k << ' ' << i;
      changes += std::exchange(before, face.contacts) != face.contacts;
    }
  }
  EXPECT_GT(changes, 3000);
}

TEST(FaceEnds, ASlidingBlockDoesNotSinkAtTheJointsOfItsFloor) {
  constexpr double kn = 2e8;
  for (const double speed : {1.0, -1.0}) {
    Scene scene;
    use_law(scene, stiff(0.0, kn));
    scene.model.settings.damping = 0.2;
    for (int i = -8; i < 8; ++i)
      scene.box(i, -1, 1, 1, true);
    const int slider = scene.box(-0.7, 0, 1.3, 0.6);
    scene.gravity(0, -10);
    scene.steps(6000);  // comes to rest
    const double level = scene.centroid(slider).y();
    while (std::abs(scene.centroid(slider).x()) < 5.0) {
      scene.velocity(slider, speed, scene.model.blocks.velocity.col(slider).y());
      scene.step();
    }
    EXPECT_LT(level - scene.centroid(slider).y(),
              1.5 * scene.weight(slider) / (1.3 * kn))
        << speed;
  }
}

/// Lets a stack of loose bricks slide and topple. Returns the motion of its blocks in
/// the frame of the scene.
std::vector<Vec2> motion_of_stack(const Frame& frame, bool rigid) {
  Scene scene(frame);
  scene.model.settings.rigid = rigid;
  scene.model.settings.damping = 0.3;
  use_law(scene, stiff(0.6, 4e9));
  scene.box(-1, -1, 12, 1, true);
  for (int row = 0; row < 6; ++row)
    for (int i = 0; i < 6; ++i)
      scene.box(i + 0.5 * (row % 2), 0.5 * row, 1, 0.5);
  std::vector<Vec2> motion;
  for (int b = 0; b < scene.model.blocks.size(); ++b)
    motion.push_back(-scene.centroid(b));
  scene.gravity(3, -9.81);
  scene.steps(6000);
  for (int b = 0; b < scene.model.blocks.size(); ++b)
    motion[static_cast<std::size_t>(b)] += scene.centroid(b);
  return motion;
}

TEST(FaceEnds, LooseBricksMoveAlikeInEveryFrame) {
  for (const bool rigid : {true, false}) {
    const std::vector<Vec2> expected = motion_of_stack({}, rigid);
    double largest = 0.0;
    for (const Vec2& way : expected)
      largest = std::max(largest, way.norm());
    EXPECT_GT(largest, 1e-3);
    for (const Frame& frame :
         {Frame{33 * degree}, Frame{90 * degree}, Frame{0.0, {1e-13, 0.0}},
          Frame{0.0, {1e-13, -1e-13}}, Frame{-2.2, {30, -7}}}) {
      const std::vector<Vec2> found = motion_of_stack(frame, rigid);
      for (std::size_t b = 0; b < found.size(); ++b)
        EXPECT_LE((found[b] - expected[b]).norm(), 1e-7 * largest)
            << frame.angle << ' ' << b;
    }
  }
}

}  // namespace
}  // namespace blocks
