// Blocks that are not convex: every side carries, and a notch holds what lies in it.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::random_frames;
using scenes::Scene;

Scene quiet_scene(const Frame& frame) {
  Scene scene(frame);
  scene.model.settings.damping = 0.5;
  scene.model.settings.friction = 0.5;
  return scene;
}

double deepest(const Model& model) { return totals(model).worst_overlap; }

// The centroid of an L lies in front of its inner sides, that of a U in its hollow: by
// the depth of the centroid they would stop nothing.
TEST(ReentrantBlock, InnerSidesCarry) {
  for (const Frame& frame : random_frames(8)) {
    Scene scene = quiet_scene(frame);
    scene.add({{0, 0}, {0, 3}, {1, 3}, {1, 1}, {3, 1}, {3, 0}}, true);
    scene.add({{5, 0}, {5, 3}, {6, 3}, {6, 1}, {8, 1}, {8, 3}, {9, 3}, {9, 0}}, true);
    const int on_l = scene.box(1.5, 1.02, 1, 1), in_u = scene.box(6.5, 1.02, 1, 1);
    scene.gravity(0, -10);
    scene.run(2.0);
    for (const int b : {on_l, in_u}) {
      const double sunk =
          scene.weight(b) / (2.0 * scene.model.settings.normal_stiffness);
      EXPECT_NEAR(scene.centroid(b).y(), 1.5 - sunk, 1e-5);
      EXPECT_LT(scene.velocity(b).norm(), 1e-4);
    }
  }
}

// A box pressed into the corner of an L: its own corner is beyond the ends of both
// inner sides, and both carry it. W / 2Kn below, and as much beside under the same
// pull.
TEST(ReentrantBlock, NotchHoldsACorner) {
  for (const Frame& frame : random_frames(8)) {
    Scene scene = quiet_scene(frame);
    scene.model.settings.friction = 0.0;
    scene.add({{0, 0}, {0, 3}, {1, 3}, {1, 1}, {3, 1}, {3, 0}}, true);
    const int box = scene.box(1, 1, 1, 1);
    scene.gravity(-10, -10);
    scene.run(2.0);
    const double sunk = scene.model.blocks.mass[box] * 10.0 /
                        (2.0 * scene.model.settings.normal_stiffness);
    EXPECT_NEAR(scene.centroid(box).x(), 1.5 - sunk, 1e-6);
    EXPECT_NEAR(scene.centroid(box).y(), 1.5 - sunk, 1e-6);
    EXPECT_LT(std::abs(scene.model.blocks.spin[box]), 1e-6);
    EXPECT_NEAR(deepest(scene.model), sunk, 1e-6);
  }
}

// The two halves of a bar beside a stem lie on one line: a corner in the notch of the
// one is no corner in the notch of the other, whichever comes first.
TEST(ReentrantBlock, NotchIsOnItsSideOfTheStem) {
  for (const Frame& frame : random_frames(8))
    for (const double side : {-1.0, 1.0}) {
      Scene scene = quiet_scene(frame);
      scene.model.settings.friction = 0.0;
      scene.add({{-1, -0.4},
                 {-1, 0},
                 {-0.15, 0},
                 {-0.15, 0.6},
                 {0.15, 0.6},
                 {0.15, 0},
                 {1, 0},
                 {1, -0.4}},
                true);
      geometry::Polygon stone = {{0.15, 0}, {0.3, 0.3}, {0.65, 0.3}, {0.65, 0}};
      if (side < 0) {
        for (Vec2& p : stone)
          p.x() = -p.x();
        std::reverse(stone.begin(), stone.end());
      }
      const int b = scene.add(stone);
      scene.gravity(-6 * side, -8);
      scene.run(1.0);
      EXPECT_LT(deepest(scene.model), 1e-3);
      EXPECT_LT(scene.velocity(b).norm(), 1e-4);
    }
}

// Out of the hollow of a U and past its rim nothing holds: a corner near one leg is no
// contact of the other, though it is behind the line of its outer side.
TEST(ReentrantBlock, HollowIsEmpty) {
  for (const Frame& frame : random_frames(8)) {
    Scene scene = quiet_scene(frame);
    scene.add({{0, 0}, {0, 3}, {1, 3}, {1, 1}, {3, 1}, {3, 3}, {4, 3}, {4, 0}}, true);
    const int box = scene.box(1.05, 1.5, 1.9, 1);
    scene.velocity(box, 0, 1.0);
    scene.run(3.0);
    EXPECT_NEAR(scene.centroid(box).y(), 5.0, 0.01);
    EXPECT_EQ(scene.model.worst_overlap, 0.0);
  }
}

/// Two stones that stand on each other with undercut sides, notched or not.
std::vector<geometry::Polygon> undercut_stones(bool notched, double shift) {
  geometry::Polygon low = {{-0.7, -2}, {-1, 0}, {1, 0}, {0.7, -2}};
  geometry::Polygon high = {{-1 + shift, 0}, {-0.7, 2}, {0.7, 2}, {1 + shift, 0}};
  if (notched)
    low.push_back({0, -1.5}), high.insert(high.begin() + 2, {0, 1.5});
  return {low, high};
}

// Two stones whose slanted sides cross: neither corner of the common face is in the
// other stone, and the upper one is carried all the same, by W / 2Kn as on any face.
TEST(CrossingSides, CarryAStone) {
  for (const Frame& frame : random_frames(8))
    for (const double shift : {-3e-5, 3e-5})
      for (const bool notched : {false, true}) {
        Scene scene = quiet_scene(frame);
        scene.model.settings.normal_stiffness = 1e6;
        const auto stones = undercut_stones(notched, shift);
        scene.add(stones[0], true);
        const int stone = scene.add(stones[1]);
        scene.gravity(0, -10);
        scene.run(2.0);
        const double sunk =
            scene.weight(stone) / (2.0 * scene.model.settings.normal_stiffness);
        EXPECT_NEAR(deepest(scene.model), sunk, 1e-3 * sunk);
        EXPECT_LT(std::abs(scene.model.blocks.spin[stone]), 1e-5);
        EXPECT_LT(scene.velocity(stone).norm(), 1e-4);
      }
}

// A wedge beside the arm of an L, its upper corner level with the arm's top up to the
// slack: the lines of the two sides cross, the sides are apart, and nothing acts.
TEST(CrossingSides, CrossWithinTheirLengths) {
  for (const Frame& frame : random_frames(8)) {
    Scene scene(frame);
    scene.add({{0, 0}, {0, 2}, {1, 2}, {1, 1}, {4, 1}, {4, 0}}, true);
    scene.add({{1.2, 2 + 0.99e-6}, {1.5, 2 + 1.5e-6}, {1.45, 1.5}, {1.25, 1.5}});
    scene.steps(1);
    EXPECT_TRUE(scene.model.contacts.empty());
  }
}

// A corner that acts for the sake of a crossing lies outside of the other block, and of
// its bounding box: it is found for any boxes and tolerance.
TEST(CrossingSides, AreFoundForAnyBoxesAndTolerance) {
  const auto rest = [](int boxes, double tolerance) {
    Scene scene = quiet_scene({0.785, {0, 0}});
    Settings& s = scene.model.settings;
    s.normal_stiffness = s.shear_stiffness = 1e5;
    s.lower = {-5, -5}, s.upper = {5, 5};
    s.boxes_x = s.boxes_y = boxes;
    s.contact_tolerance = tolerance;
    scene.add({{0, 0}, {1, 0}, {0.5, -0.4}}, true);
    scene.add({{0, 0}, {0.35, 1}, {0.65, 1}, {1, 0}});
    scene.gravity(0, -10);
    scene.run(1.0);
    EXPECT_LT(deepest(scene.model), 0.05);
    return Eigen::Matrix2Xd(scene.model.blocks.corner);
  };
  const Eigen::Matrix2Xd coarse = rest(10, 0.1);
  EXPECT_EQ(rest(900, 0.003), coarse);
  EXPECT_EQ(rest(10, 0.0001), coarse);
  EXPECT_EQ(rest(400, 0.0001), coarse);
}

}  // namespace
}  // namespace blocks
