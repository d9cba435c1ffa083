// What follows the pieces of a block that splits: corners, contacts and loads.
#include "model/splitting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "dynamics/cracks/pieces.hpp"
#include "dynamics/loads/loads.hpp"
#include "scenes/joint_law.hpp"

namespace blocks {
namespace {

using geometry::SplitLine;
using scenes::Frame;
using scenes::Scene;
using scenes::three_frames;

BlockSplit split_of(const Blocks& blocks, int b, const SplitLine& line) {
  geometry::Split cut = geometry::split_outline(blocks.outline(b), line, 1e-6);
  EXPECT_EQ(cut.fault, geometry::SplitFault::none);
  BlockSplit split = dynamics::pieces_of(blocks, b, std::move(cut));
  split.joint = 9;
  return split;
}

/// A bed of bricks under a long block, pressed together, with a re-entrant block.
Model bed(const Frame& frame) {
  Scene scene(frame);
  scene.box(-1, -1, 12, 1, true);
  for (int i = 0; i < 10; ++i)
    scene.box(i, 0, 1, 1);
  scene.box(0, 1, 10, 1);
  scene.add({{2, 2}, {2, 4}, {3, 4}, {3, 3}, {4, 3}, {4, 4}, {5, 4}, {5, 2}});
  scene.plane({-0.001, 5}, {-0.001, -1});
  scene.gravity(0, -10);
  scene.model.blocks.joint.assign(scene.model.blocks.joint.size(), 4);
  scene.steps(40);
  return scene.model;
}

constexpr int long_block = 11, reentrant = 12;

std::vector<BlockSplit> splits_of(const Model& model, const Frame& frame) {
  const auto line = [&](int b, const Vec2& along) {
    return SplitLine{model.blocks.centroid.col(b), frame.turn(along)};
  };
  return {split_of(model.blocks, 4, line(4, {1, 2})),
          split_of(model.blocks, long_block, line(long_block, {0.2, 1})),
          split_of(model.blocks, reentrant, line(reentrant, {0.1, 1}))};
}

TEST(Splitting, MakesBlocksThatAreSoundAndLeavesTheOthers) {
  for (const Frame& frame : three_frames) {
    Model model = bed(frame);
    const Blocks before = model.blocks;
    const std::vector<BlockSplit> splits = splits_of(model, frame);
    split_blocks(model, splits);
    const Blocks& blocks = model.blocks;
    ASSERT_EQ(blocks.size(), before.size() + 3);
    ASSERT_EQ(static_cast<int>(blocks.corner_block.size()), blocks.corners());
    for (int b = 0; b < blocks.size(); ++b) {
      for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c) {
        EXPECT_EQ(blocks.corner_block[c], b);
        EXPECT_EQ(blocks.corner_block[blocks.next[c]], b);
        EXPECT_EQ(blocks.previous[blocks.next[c]], c);
        if (b >= before.size()) {
          EXPECT_EQ(Vec2(blocks.arm.col(c)), blocks.present_arm(c));
        }
      }
      const geometry::SectionProperties section =
          geometry::section_properties(blocks.outline(b));
      EXPECT_NEAR(blocks.area[b], section.area, 1e-9);
      EXPECT_NEAR(blocks.mass[b], 2000.0 * section.area, 1e-5);
      EXPECT_LT((Vec2(blocks.centroid.col(b)) - section.centroid).norm(), 1e-9);
      const bool split = b >= before.size() ||
                         std::any_of(splits.begin(), splits.end(),
                                     [&](const auto& s) { return s.block == b; });
      if (!split) {
        EXPECT_EQ(blocks.outline(b), before.outline(b));
        EXPECT_EQ(blocks.velocity.col(b), before.velocity.col(b));
      }
      // Each piece has one side on the chord.
      EXPECT_EQ(std::count(blocks.joint.begin() + blocks.first_corner[b],
                           blocks.joint.begin() + blocks.first_corner[b + 1], 9),
                split ? 1 : 0);
      const geometry::OutlineCheck check = geometry::check_outline(blocks.outline(b));
      EXPECT_EQ(check.fault, geometry::OutlineFault::none);
      EXPECT_EQ(blocks.convex[b] != 0, check.convex);
      int parts = 0;
      blocks.each_cut([&](int of, std::span<const int> corners) {
        parts += of == b;
        for (const int c : corners)
          EXPECT_LT(c, blocks.corners_of(of));
      });
      EXPECT_EQ(parts > 0, !check.convex);
    }
  }
}

TEST(Splitting, KeepsSpringsAtTheirCornersAndFeet) {
  for (const Frame& frame : three_frames) {
    Model model = bed(frame);
    const Model before = model;
    ASSERT_GT(before.contacts.size(), 30U);
    ASSERT_GT(before.plane_contacts.size(), 1U);
    split_blocks(model, splits_of(model, frame));
    const Blocks& blocks = model.blocks;
    ASSERT_EQ(model.contacts.size(), before.contacts.size());
    int moved = 0;
    for (const Contact& old : before.contacts) {
      const Vec2 at = before.blocks.corner.col(old.corner);
      const auto now = std::find_if(model.contacts.begin(), model.contacts.end(),
                                    [&](const auto& c) {
                                      return c.normal_elastic == old.normal_elastic &&
                                             c.shear_elastic == old.shear_elastic &&
                                             Vec2(blocks.corner.col(c.corner)) == at;
                                    });
      ASSERT_NE(now, model.contacts.end());
      // The edge is the old one, or the part of it that holds the foot of the corner.
      const Vec2 p = blocks.corner.col(now->edge),
                 q = blocks.corner.col(blocks.next[now->edge]);
      const Vec2 from = before.blocks.corner.col(old.edge);
      const Vec2 to = before.blocks.corner.col(before.blocks.next[old.edge]);
      const Vec2 along = (to - from).normalized();
      EXPECT_LT(std::abs(geometry::cross(along, Vec2(p - from))), 1e-12);
      EXPECT_LT(std::abs(geometry::cross(along, Vec2(q - from))), 1e-12);
      EXPECT_GE((at - p).dot(along), std::min(0.0, (at - from).dot(along)) - 1e-9);
      EXPECT_LE((at - q).dot(along), std::max(0.0, (at - to).dot(along)) + 1e-9);
      moved += blocks.corner_block[now->edge] != before.blocks.corner_block[old.edge];
    }
    EXPECT_GT(moved, 3);
    for (std::size_t i = 1; i < model.contacts.size(); ++i)
      EXPECT_LT(sort_key(blocks, model.contacts[i - 1]),
                sort_key(blocks, model.contacts[i]));
    const std::vector<PlaneContact>& planes = model.plane_contacts;
    ASSERT_EQ(planes.size(), before.plane_contacts.size());
    for (const PlaneContact& old : before.plane_contacts) {
      const Vec2 at = before.blocks.corner.col(old.corner);
      EXPECT_TRUE(std::any_of(planes.begin(), planes.end(), [&](const auto& now) {
        return now.normal_elastic == old.normal_elastic &&
               Vec2(blocks.corner.col(now.corner)) == at;
      }));
    }
    for (std::size_t i = 1; i < planes.size(); ++i)
      EXPECT_LT(planes[i - 1].corner, planes[i].corner);
  }
}

/// The force of the loads, and their moment about the origin.
std::pair<Vec2, double> sum_of_loads(Model model) {
  Blocks& blocks = model.blocks;
  model.plane_contacts.clear();
  blocks.velocity.setZero(), blocks.spin.setZero();
  dynamics::Workers workers;
  dynamics::add_loads(model, {0, blocks.size()}, workers);
  Vec2 force(0, 0);
  double moment = 0.0;
  for (int b = 0; b < blocks.size(); ++b) {
    force += blocks.force.col(b);
    moment += blocks.moment[b] +
              geometry::cross(Vec2(blocks.centroid.col(b)), Vec2(blocks.force.col(b)));
  }
  return {force, moment};
}

TEST(Splitting, DividesLoadsWithoutChangingTheirSum) {
  for (const Frame& frame : {three_frames[0], three_frames[1]}) {
    Model model = bed(frame);
    model.loads.function = {{0, 1}, {1, 1}};
    model.loads.pressures = {
        {long_block, 1, 1e5, 3e5, 0.0}, {4, 1, 2e5, -1e5, 0.0}, {5, 0, 1.0, 2.0, 0.0}};
    model.loads.quiet_sides = {{long_block, 3, 3000, 1500, {1e4, 2e5}, {-2e4, 1e5}}};
    const auto [force, moment] = sum_of_loads(model);
    model.loads.forces = {{4, {1e5, -3e5}, 0.0}};
    split_blocks(model, splits_of(model, frame));
    // A force at the centroid becomes two, whose moment about any point is the same.
    const std::vector<CentroidForce> forces = model.loads.forces;
    ASSERT_EQ(forces.size(), 2U);
    EXPECT_NEAR((forces[0].force + forces[1].force - Vec2(1e5, -3e5)).norm(), 0, 1e-9);
    EXPECT_NEAR(forces[0].force.x() / forces[1].force.x(),
                model.blocks.mass[forces[0].block] / model.blocks.mass[forces[1].block],
                1e-9);
    model.loads.forces.clear();
    EXPECT_EQ(model.loads.pressures.size(), 5U);
    EXPECT_EQ(model.loads.quiet_sides.size(), 2U);
    const auto [now, turned] = sum_of_loads(model);
    EXPECT_LT((now - force).norm(), 1e-9 * force.norm());
    EXPECT_NEAR(turned, moment, 1e-9 * std::abs(moment) + 1e-3);
  }
}

}  // namespace
}  // namespace blocks
