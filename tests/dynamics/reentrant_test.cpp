// Contacts of blocks that are not convex.
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

// The centroid of an L is in front of its inner sides, and that of a U is in its
// hollow. A limit by the depth of the centroid would exclude all contacts of these
// sides.
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

// A box is pressed into the re-entrant corner of an L. Its corner is beyond the ends of
// both inner sides, and both carry it. It overlaps by W / (2 Kn) in both directions.
TEST(ReentrantBlock, ReentrantCornerHoldsABox) {
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

// The two arms of the block are on one line, on either side of a stem. A corner in the
// re-entrant corner on one side must not count for the other side.
TEST(ReentrantBlock, ReentrantCornerIsOnItsSideOfTheStem) {
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

// A box leaves the hollow of a U without contact. A corner near one leg is behind the
// line of the outer side of the other leg.
TEST(ReentrantBlock, HollowHasNoContact) {
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

/// Two stones on top of each other with undercut sides, with or without a re-entrant
/// corner.
std::vector<geometry::Polygon> undercut_stones(bool is_reentrant, double shift) {
  geometry::Polygon low = {{-0.7, -2}, {-1, 0}, {1, 0}, {0.7, -2}};
  geometry::Polygon high = {{-1 + shift, 0}, {-0.7, 2}, {0.7, 2}, {1 + shift, 0}};
  if (is_reentrant)
    low.push_back({0, -1.5}), high.insert(high.begin() + 2, {0, 1.5});
  return {low, high};
}

// The slanted sides of two stones cross. Neither corner of the common face is in the
// other stone. The upper stone still overlaps by W / (2 Kn), as on any face.
TEST(CrossingSides, CarryTheUpperStone) {
  for (const Frame& frame : random_frames(8))
    for (const double shift : {-3e-5, 3e-5})
      for (const bool is_reentrant : {false, true}) {
        Scene scene = quiet_scene(frame);
        scene.model.settings.normal_stiffness = 1e6;
        const auto stones = undercut_stones(is_reentrant, shift);
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

// A wedge is beside the arm of an L, and its upper corner is level with the top of the
// arm up to the slack. The lines of the two sides cross, but the sides are apart.
TEST(CrossingSides, MustCrossWithinTheirLengths) {
  for (const Frame& frame : random_frames(8)) {
    Scene scene(frame);
    scene.add({{0, 0}, {0, 2}, {1, 2}, {1, 1}, {4, 1}, {4, 0}}, true);
    scene.add({{1.2, 2 + 0.99e-6}, {1.5, 2 + 1.5e-6}, {1.45, 1.5}, {1.25, 1.5}});
    scene.steps(1);
    EXPECT_TRUE(scene.model.contacts.empty());
  }
}

// A corner that acts because sides cross is outside the other block and outside its
// bounding box.
TEST(CrossingSides, DoNotDependOnBoxesOrTolerance) {
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
