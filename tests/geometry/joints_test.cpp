#include "geometry/joints.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "area_judge.hpp"
#include "geometry/block_shape.hpp"
#include "geometry/overlap.hpp"

namespace blocks::geometry {
namespace {

Polygon rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x, y + height}, {x + width, y + height}, {x + width, y}};
}

// Shapes on a small lattice meet in every way. They touch, are nested or identical,
// cross without a corner inside, or have teeth in gaps.
Polygon lattice_shape(std::mt19937& random) {
  const auto draw = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const std::vector<Polygon> shapes = {
      rectangle(0, 0, 2, 2),
      rectangle(0, 0, 1, 6),
      rectangle(0, 0, 6, 1),
      {{0, 0}, {1, 3}, {3, 1}},
      {{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}},
      {{0, 0}, {0, 3}, {1, 3}, {1, 1}, {2, 1}, {2, 3}, {3, 3}, {3, 0}},
      {{0, 0}, {2, 3}, {1, 0}, {2, -3}},
      {{0, 0}, {2, 4}, {6, 4}, {4, 0}}};
  Polygon shape = shapes[static_cast<std::size_t>(draw(0, 7))];
  const Vec2 shift(draw(0, 11), draw(0, 11));
  for (Vec2& corner : shape)
    corner += shift;
  return shape;
}

/// Requires the pairs and areas that the exact judge finds.
void expect_the_judge_agrees(const std::vector<Polygon>& outlines) {
  const auto pairs = overlapping_pairs(outlines);
  std::size_t next = 0;
  for (std::size_t i = 0; i < outlines.size(); ++i)
    for (std::size_t j = i + 1; j < outlines.size(); ++j) {
      const testing::Exact area = testing::common_area(outlines[i], outlines[j]);
      if (area == 0)
        continue;
      ASSERT_LT(next, pairs.size()) << i << " and " << j << " were missed";
      EXPECT_EQ(pairs[next].first, static_cast<int>(i));
      EXPECT_EQ(pairs[next].second, static_cast<int>(j));
      const auto expected = area.convert_to<double>();
      EXPECT_NEAR(pairs[next].area, expected, 1e-12 + 1e-12 * expected);
      ++next;
    }
  EXPECT_EQ(next, pairs.size());
}

TEST(BlockOverlap, AgreesWithTheJudgeOnALattice) {
  std::mt19937 random(5);
  for (int scene = 0; scene < 12; ++scene) {
    std::vector<Polygon> outlines;
    for (int i = 0; i < 14; ++i)
      outlines.push_back(lattice_shape(random));
    expect_the_judge_agrees(outlines);
  }
}

// The sides of turned shapes touch within a unit in the last place.
TEST(BlockOverlap, AgreesWithTheJudgeForTurnedShapes) {
  std::mt19937 random(6);
  for (int scene = 0; scene < 4; ++scene) {
    const double angle = 0.3 + scene;
    std::vector<Polygon> outlines;
    for (int i = 0; i < 10; ++i) {
      outlines.push_back(lattice_shape(random));
      for (Vec2& p : outlines.back())
        p = Vec2(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                 std::sin(angle) * p.x() + std::cos(angle) * p.y());
    }
    expect_the_judge_agrees(outlines);
  }
}

TEST(Joints, HaveTJunctionsInARunningBond) {
  const auto running = find_joints(
      {rectangle(0, 0, 2, 1), rectangle(-1, 1, 2, 1), rectangle(1, 1, 2, 1)});
  ASSERT_EQ(running.t_junctions.size(),
            4U);  // Two corners are above and two ends below.
  EXPECT_EQ(running.t_junctions[0].block, 0);
  EXPECT_EQ(running.t_junctions[0].other, 1);
  EXPECT_EQ(running.t_junctions[0].place, Vec2(0, 1));
  EXPECT_TRUE(running.slits.empty());
}

TEST(Joints, HaveNoTJunctionInAStackBond) {
  const auto stack = find_joints(
      {rectangle(0, 0, 2, 1), rectangle(0, 1, 2, 1), rectangle(2, 0, 2, 1)});
  EXPECT_TRUE(stack.t_junctions.empty());
  EXPECT_TRUE(stack.slits.empty());
}

// Two T-junctions are at each joint that meets the long side of a brick.
TEST(Joints, KeepTheirTJunctionsInATurnedWall) {
  const auto wall = [](double angle) {
    std::vector<Polygon> bricks;
    for (int row = 0; row < 6; ++row)
      for (int i = 0; i < 8; ++i)
        bricks.push_back(rectangle(2 * i - row % 2, row, 2, 1));
    for (Polygon& brick : bricks)
      for (Vec2& corner : brick)
        corner = {std::cos(angle) * corner.x() - std::sin(angle) * corner.y(),
                  std::sin(angle) * corner.x() + std::cos(angle) * corner.y()};
    return find_joints(bricks).t_junctions.size();
  };
  const std::size_t straight = wall(0.0);
  EXPECT_EQ(
      straight,
      5U * 30U);  // Each of five seams has 15 joints or ends, with two corners each.
  for (const double angle : {0.1, 0.3, 1.0, 2.5})
    EXPECT_EQ(wall(angle), straight) << angle;
}

// A slit is at least one unit in the last place wide. A wide gap is an open joint and
// not a slit.
TEST(Joints, NarrowGapsAreSlitsWithTheirWidth) {
  const auto above = [](double y) {
    return find_joints({rectangle(0, 0, 2, 1), rectangle(0.5, y, 2, 1)});
  };
  for (const double y : {std::nextafter(1.0, 2.0), 1.0 + 1e-9, 1.0005}) {
    const Joints joints = above(y);
    ASSERT_EQ(joints.slits.size(), 1U) << y;
    EXPECT_DOUBLE_EQ(joints.slits[0].width, y - 1.0);
    // If they are one unit apart, two corners are inside edges up to rounding.
    EXPECT_EQ(joints.t_junctions.size(), y < 1.0 + 1e-12 ? 2U : 0U);
  }
  EXPECT_TRUE(above(1.1).slits.empty());
  EXPECT_TRUE(above(1.0 - 1e-6).slits.empty());  // They overlap.
}

// Four blocks nearly meet in one point. The other two lie between the two that are
// diagonal to each other.
TEST(Joints, DiagonalBlocksAtACornerLeaveNoSlit) {
  const double shift = 1e-4;
  EXPECT_TRUE(find_joints({rectangle(0, 0, 1, 1), rectangle(1, 0, 1, 1),
                           rectangle(0, 1, 1 + shift, 1),
                           rectangle(1 + shift, 1, 1 - shift, 1)})
                  .slits.empty());
}

TEST(Joints, AWedgeThatOpensByOneUlpIsASlit) {
  Polygon tilted = rectangle(0, 1, 2, 1);
  tilted[3].y() = std::nextafter(1.0, 2.0);
  const Joints joints = find_joints({rectangle(0, 0, 2, 1), tilted});
  ASSERT_EQ(joints.slits.size(), 1U);
  EXPECT_EQ(joints.slits[0].width, std::ldexp(1.0, -52));
  EXPECT_DOUBLE_EQ(joints.slits[0].place.x(), 2.0);
}

// The sides of a sharp wedge face each other, and the space between them may be filled.
TEST(Joints, AFilledWedgeIsNoSlit) {
  const Polygon below = {{0, 0}, {10, 0}, {10, -3}, {0, -3}};
  const Polygon above = {{0, 0}, {0, 3}, {10, 3}, {10, 0.02}};
  const Polygon tip = {{0, 0}, {10, 0.02}, {10, 0}};
  EXPECT_TRUE(find_joints({below, above, tip}).slits.empty());
  ASSERT_EQ(find_joints({below, above}).slits.size(), 1U);
  EXPECT_NEAR(find_joints({below, above}).slits[0].width, 0.02, 1e-6);
}

TEST(Joints, AFarBlockDoesNotHideASlit) {
  const Joints joints = find_joints(
      {rectangle(5, 0, 1, 1), rectangle(6.0001, 0, 1, 1), rectangle(1e12, 0, 1, 1)});
  ASSERT_EQ(joints.slits.size(), 1U);
  EXPECT_FALSE(joints.slits[0].by_rounding);
}

TEST(BlockShape, HasTheAspectRatioOfARectangle) {
  const BlockShape bar = measure_shape(rectangle(1e6, -1e6, 8, 2));
  EXPECT_DOUBLE_EQ(bar.area, 16);
  EXPECT_DOUBLE_EQ(bar.aspect, 4);
  EXPECT_DOUBLE_EQ(bar.shortest_edge, 2);
  EXPECT_DOUBLE_EQ(bar.smallest_angle, 90);
}

TEST(BlockShape, HasTheSmallestAngleOfAWedge) {
  const BlockShape wedge = measure_shape({{0, 0}, {1, 1}, {1, 0}});
  EXPECT_DOUBLE_EQ(wedge.smallest_angle, 45);
  EXPECT_DOUBLE_EQ(wedge.shortest_edge, 1);
}

// The interior angle of a re-entrant corner is above 180 degrees.
TEST(BlockShape, MeasuresReentrantAnglesAbove180Degrees) {
  const BlockShape arrow = measure_shape({{0, 0}, {2, 3}, {1, 0}, {2, -3}});
  EXPECT_NEAR(arrow.smallest_angle, 180 / M_PI * (std::atan(3) - std::atan(1.5)),
              1e-12);
}

TEST(CoarsestUlp, IsThatOfTheLargestCoordinate) {
  EXPECT_EQ(coarsest_ulp(rectangle(-1.5, 0, 1, 1)), std::ldexp(1.0, -52));
  EXPECT_EQ(coarsest_ulp(rectangle(1e6, 0, 1, 1)), std::ldexp(1.0, -33));
}

}  // namespace
}  // namespace blocks::geometry
