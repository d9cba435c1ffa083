// Contacts at joints between blocks. A sliding block passes the joints of its floor as
// if the floor were one block.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::random_frames;
using scenes::Scene;

// The right neighbour is a little lower and pressed in. The two faces are parallel, so
// rounding decides which corner is deepest. In either case the end of each face that is
// inside the other block acts.
TEST(SlantedJoint, HoldsALowerNeighbour) {
  for (const Frame& frame : random_frames()) {
    Scene scene(frame);
    const double in = 0.02, down = 1e-4;
    scene.add({{0, 0}, {0, 2}, {3.0, 2}, {3.13, 0}});
    scene.add({{3.13 - in, -down}, {3.0 - in, 2 - down}, {6, 2 - down}, {6, -down}});
    scene.steps(1);
    std::vector<std::pair<int, int>> acting;  // The pairs are corner and edge.
    for (const Contact& contact : scene.model.contacts)
      acting.emplace_back(contact.corner, contact.edge);
    EXPECT_EQ(acting, (std::vector<std::pair<int, int>>{{2, 4}, {4, 2}}))
        << frame.angle;
  }
}

/// A box that is at rest on a floor of boxes and ready to slide.
struct SlidingBox {
  explicit SlidingBox(const Frame& frame, double friction, double damping)
      : scene(frame) {
    scene.model.settings.friction = friction;
    scene.model.settings.damping = 0.9;
    for (int i = -30; i < 30; ++i)
      scene.box(i, -1, 1, 1, true);
    box = scene.box(0.13, 0, 2.3, 1);
    scene.gravity(0, -10);
    scene.run(1.0);
    scene.model.settings.damping = damping;
    rest = scene.centroid(box).y();
  }
  Scene scene;
  int box = 0;
  double rest = 0.0;  ///< height at rest
};

// In polygon contact a sliding box often catches at the joints of its floor. It must
// decelerate by mu g, not turn, and overlap by W / (2 Kn) at its own two corners.
TEST(FloorOfBoxes, LetsABoxSlide) {
  for (const Frame& frame : random_frames(8))
    for (const double speed : {5.0, -5.0}) {
      SlidingBox s(frame, 0.1, 0.3);
      s.scene.velocity(s.box, speed, 0);
      const double began = s.scene.model.time;
      s.scene.run(2.0);
      const double time = s.scene.model.time - began;
      EXPECT_GT(std::abs(s.scene.centroid(s.box).x() - 1.28), 7.5);
      EXPECT_NEAR(std::abs(s.scene.velocity(s.box).x()), 5.0 - 0.1 * 10 * time, 2e-3);
      EXPECT_NEAR(s.scene.model.blocks.spin[s.box], 0.0, 1e-6);
      const double overlap =
          s.scene.weight(s.box) / (2 * s.scene.model.settings.normal_stiffness);
      EXPECT_NEAR(s.scene.centroid(s.box).y(), 0.5 - overlap, 1e-3 * overlap)
          << frame.angle;
    }
}

// The boxes of the floor are fixed or free on a base. The sides of the sliding block
// are upright or lean over the joint.
TEST(FloorOfBoxes, LetsAnyShapeSlideOverFreeBoxes) {
  const std::vector<geometry::Polygon> shapes = {{{0, 0}, {0, 1}, {1, 1}, {1, 0}},
                                                 {{0.2, 0}, {0, 1}, {1, 1}, {0.8, 0}},
                                                 {{0, 0}, {0.2, 1}, {0.8, 1}, {1, 0}}};
  for (const geometry::Polygon& shape : shapes)
    for (const bool fixed : {true, false})
      for (const Frame& frame : random_frames(2)) {
        Scene scene(frame);
        Settings& s = scene.model.settings;
        s.friction = 0.4, s.damping = 0.2;
        s.normal_stiffness = s.shear_stiffness = 1e8;
        scene.box(-1, -2, 14, 1, true);
        scene.box(-1, -1, 1, 1, true), scene.box(12, -1, 1, 1, true);
        for (int i = 0; i < 12; ++i)
          scene.box(i, -1, 1, 1, fixed);
        geometry::Polygon outline;
        for (const Vec2& p : shape)
          outline.push_back(p + Vec2(0.4, 0));
        const int slider = scene.add(outline);
        scene.gravity(0, -10);
        scene.velocity(slider, 10, 0);
        scene.run(1.0);
        EXPECT_GT(scene.centroid(slider).x(), 8.5);
        if (!fixed && shape[0].x() > 0)
          continue;  // The block tilts and hits boxes that spring up in front of it.
        // A free box sinks under the slider, so the next box is higher. Its side is a
        // step that may push the slider back for a moment.
        const double expected = 10.0 - 4.0 * scene.model.time;
        EXPECT_NEAR(scene.velocity(slider).x(), expected,
                    fixed ? 1e-3 : 0.005 * expected);
      }
}

// The floor is turned and a million units away from the origin. Position, speed and
// overlap are those of a box on one smooth floor.
TEST(FloorOfBoxes, LetsABoxSlideOverAThousandJoints) {
  const Frame frame{0.7, Vec2(1e6, -1e6)};
  Scene scene(frame);
  Settings& s = scene.model.settings;
  s.lower = frame.offset - Vec2(2000, 2000), s.upper = frame.offset + Vec2(2000, 2000);
  s.friction = 0.1, s.damping = 0.9, s.fraction = 0.016;
  for (int i = 0; i < 1010; ++i)
    scene.box(i, -1, 1, 1, true);
  const int box = scene.box(1.13, 0, 2.3, 1);
  scene.gravity(0, -10);
  scene.run(1.0);
  s.damping = 0.3;
  scene.velocity(box, 44, 0);
  const double began = scene.model.time;
  scene.run(43.0);
  const double t = scene.model.time - began;
  EXPECT_NEAR(scene.velocity(box).x(), 44 - t, 1e-3);
  EXPECT_NEAR(scene.centroid(box).x(), 2.28 + 44 * t - 0.5 * t * t, 0.05);
  EXPECT_NEAR(scene.model.blocks.spin[box], 0.0, 1e-9);
  const double overlap = scene.weight(box) / (2 * s.normal_stiffness);
  EXPECT_NEAR(scene.centroid(box).y(), 0.5 - overlap, 0.01 * overlap);
}

// Springs are transferred from one contact to the next. Without friction and damping
// the energy must not grow.
TEST(FloorOfBoxes, AddsNoEnergyToASlidingBox) {
  for (const double speed : {5.0, -5.0}) {
    SlidingBox s({}, 0.0, 0.0);
    s.scene.velocity(s.box, speed, 0);
    const double mass = s.scene.model.blocks.mass[s.box];
    const double before = 0.5 * mass * speed * speed;
    s.scene.run(2.0);
    const auto end = totals(s.scene.model);
    const double lifted = mass * 10 * (s.scene.centroid(s.box).y() - s.rest);
    EXPECT_LT(end.kinetic_energy + lifted, before * (1 + 1e-4));
  }
}

}  // namespace
}  // namespace blocks
