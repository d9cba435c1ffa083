// Contact detection in difficult positions, in 40 random frames and at offsets up to
// 1e6 (report 3.3, figure 4, docs/contact-rule.md).
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/scene.hpp"

namespace blocks {
namespace {

using scenes::Frame;
using scenes::random_frames;
using scenes::Scene;

// Block 1 is beside the fixed block 2 and slides down its face. Without (20) and the
// nearest edge it would hang on the corner.
TEST(Figure4b, BlockSlidesDownItsNeighbour) {
  for (const Frame& frame : random_frames()) {
    Scene scene(frame);
    scene.box(0, 0, 1, 1, true);             // This is block 2.
    const int b = scene.box(-1, 0.5, 1, 1);  // This is block 1.
    scene.gravity(0, -10);
    scene.run(0.3);
    const double dt = scene.dt(), n = static_cast<double>(scene.model.steps);
    EXPECT_NEAR(scene.centroid(b).y(), 1.0 - 10 * dt * dt * n * (n + 1) / 2,
                1e-7 + 1e-9 * frame.offset.norm())
        << frame.angle << " " << frame.offset.norm();
  }
}

// The block touches its diagonal neighbour in one point and must fall freely.
TEST(DiagonalNeighbour, DoesNotHoldAFallingBlock) {
  for (const Frame& frame : random_frames()) {
    Scene scene(frame);
    scene.box(0, 0, 1, 1, true);
    // The bottom right corner of b is on the top left corner of the other block.
    const int b = scene.box(-1, 1, 1, 1);
    scene.gravity(0, -10);
    scene.run(0.3);
    const double dt = scene.dt(), n = static_cast<double>(scene.model.steps);
    EXPECT_NEAR(scene.centroid(b).y(), 1.5 - 10 * dt * dt * n * (n + 1) / 2,
                1e-7 + 1e-9 * frame.offset.norm())
        << frame.angle << " " << frame.offset.norm();
  }
}

/// Lets a stack of four bricks settle and compares its overlaps. Aligned faces have
/// four contacts (overlap W / (4 Kn)), offset faces two (W / (2 Kn)). Each brick is
/// narrower than the one below by `step`.
void settle_stack(const Frame& frame, double step, double contacts) {
  Scene scene(frame);
  scene.model.settings.damping = 0.5;
  scene.model.settings.friction = 0.6;
  scene.box(-3, -1, 6, 1, true);
  constexpr int n = 4;
  for (int i = 0; i < n; ++i) {
    const double width = 2.0 - step * i;
    scene.box(-0.5 * width, 0.5 * i, width, 0.5);
  }
  scene.gravity(0, -10);
  scene.run(1.0);
  const double k = scene.model.settings.normal_stiffness;
  double load = 0.0, sunk = 0.0;
  for (int i = 1; i <= n; ++i)
    load += scene.weight(i);
  for (int i = 0; i < n; ++i) {
    // The lowest brick is on the wide floor and has two contacts.
    sunk += load / ((i == 0 ? 2.0 : contacts) * k);
    load -= scene.weight(1 + i);
    EXPECT_NEAR(0.25 + 0.5 * i - scene.centroid(1 + i).y(), sunk,
                1e-3 * sunk + 1e-8 * frame.offset.norm())
        << "brick " << i << " angle " << frame.angle << " offset "
        << frame.offset.norm();
  }
}

TEST(Stack, WithAlignedFacesRestsOnFourContacts) {
  for (const Frame& frame : random_frames(16))
    settle_stack(frame, 0.0, 4.0);
}

TEST(Stack, WithOffsetFacesRestsOnTwoContacts) {
  for (const Frame& frame : random_frames(16))
    settle_stack(frame, 0.2, 2.0);
}

TEST(Search, ResultsDoNotDependOnBoxesOrTolerance) {
  struct Choice {
    int boxes;
    double tolerance;
  };
  const Choice choices[] = {{1, 0.1}, {7, 0.02}, {200, 0.1}, {999, 0.35}, {40, 0.005}};
  std::vector<Eigen::Matrix2Xd> ends;
  for (const Choice& choice : choices) {
    Scene scene;
    scene.model.settings.boxes_x = scene.model.settings.boxes_y = choice.boxes;
    scene.model.settings.contact_tolerance = choice.tolerance;
    scene.model.settings.friction = 0.4;
    scene.model.settings.damping = 0.3;
    scene.box(-10, -1, 20, 1, true);
    for (int row = 0; row < 4; ++row)
      for (int i = 0; i < 4; ++i)
        scene.add({{i + 0.1 * row, row * 1.05 + 0.02 * i},
                   {i + 0.2 + 0.1 * row, row * 1.05 + 0.9},
                   {i + 0.8 + 0.1 * row, row * 1.05 + 1.0},
                   {i + 0.95 + 0.1 * row, row * 1.05}});
    scene.gravity(1, -10);
    scene.velocity(16, -3, 1, 2);
    scene.run(1.0);
    ends.push_back(scene.model.blocks.corner);
    EXPECT_GT(scene.model.search.updates, 1);
  }
  for (const Eigen::Matrix2Xd& end : ends)
    EXPECT_EQ(end, ends.front());
}

// All lengths are scaled by a power of two and times stay the same. Then every number
// of the run is scaled by a power of two.
TEST(Scaling, ByAPowerOfTwoIsBitExact) {
  const auto fall = [](double scale) {
    Scene scene;
    Settings& s = scene.model.settings;
    s.lower *= scale, s.upper *= scale;
    s.contact_tolerance *= scale;
    s.materials[1].density /= scale * scale;  // The masses stay the same.
    s.friction = 0.5, s.damping = 0.2;
    scene.add(
        {{-5 * scale, -scale}, {-5 * scale, 0}, {5 * scale, 0}, {5 * scale, -scale}},
        true);
    scene.add({{0, 0.3 * scale},
               {0.2 * scale, 1.3 * scale},
               {1.1 * scale, 1.2 * scale},
               {0.9 * scale, 0.1 * scale}});
    scene.gravity(2 * scale, -10 * scale);
    scene.run(0.7);
    return Eigen::Matrix2Xd(scene.model.blocks.corner / scale);
  };
  EXPECT_EQ(fall(1.0), fall(1024.0));
}

}  // namespace
}  // namespace blocks
