// What import says of outlines that do not fit together.
#include "exchange/soundness.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace blocks::exchange {
namespace {

using geometry::Polygon;

Polygon rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {left, top}, {right, top}, {right, bottom}};
}

// A brick on two others: both its lower corners stand on one side, and the upper corner
// that the two share stands on its lower side.
TEST(Soundness, FindsJunctionsOfABrickWall) {
  const Soundness wall =
      examine({rectangle(0, 0, 2, 1), rectangle(2, 0, 4, 1), rectangle(1, 1, 3, 2)});
  EXPECT_TRUE(wall.sound());
  EXPECT_TRUE(wall.joints.slits.empty());
  EXPECT_EQ(wall.joints.t_junctions.size(), 4u);  // the shared corner is of both bricks
}

// Aligned blocks share their corners: nothing to report.
TEST(Soundness, SharedCornersAreNoJunctions) {
  const Soundness pair = examine({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)});
  EXPECT_TRUE(pair.sound());
  EXPECT_TRUE(pair.joints.t_junctions.empty());
  EXPECT_TRUE(pair.joints.slits.empty());
}

// Blocks that a drawing program left a hair apart: never snapped, always told, once.
TEST(Soundness, TellsBlocksThatNearlyMeet) {
  const double hair = 0x1p-40;
  const Soundness pair = examine({rectangle(0, 0, 1, 1), rectangle(1 + hair, 0, 2, 1)});
  EXPECT_TRUE(pair.sound());
  ASSERT_EQ(pair.joints.slits.size(), 1u);
  EXPECT_EQ(pair.joints.slits[0].first, 0);
  EXPECT_EQ(pair.joints.slits[0].second, 1);
  EXPECT_EQ(pair.joints.slits[0].width, hair);
}

// An overlap by an ulp is not one a user can mend; one of a millionth is.
TEST(Soundness, PartsRoundingFromOverlap) {
  const Soundness ulp =
      examine({rectangle(0, 0, 1, 1), rectangle(1 - 0x1p-52, 0, 2, 1)});
  EXPECT_TRUE(ulp.sound());
  EXPECT_EQ(ulp.roundings.size(), 1u);
  const Soundness real =
      examine({rectangle(0, 0, 1, 1), rectangle(1 - 0x1p-20, 0, 2, 1)});
  EXPECT_FALSE(real.sound());
  ASSERT_EQ(real.overlaps.size(), 1u);
  EXPECT_EQ(real.overlaps[0].area, 0x1p-20);
}

// A whole so slender that its length in its heights is beyond any count.
TEST(Soundness, TakesExtremeShapes) {
  const Soundness needle = examine({{{0, 0}, {1, 1}, {1e99, 0}}});
  EXPECT_TRUE(needle.sound());
  EXPECT_TRUE(needle.joints.t_junctions.empty());
}

// The law: the sense of the outlines and their order change nothing but the numbers;
// bad outlines keep the numbers of the others right.
TEST(Soundness, DoesNotDependOnSenseOrOrder) {
  const std::vector<Polygon> wall = {{{9, 9}, {10, 10}, {10, 9}, {9, 10}},  // a bow-tie
                                     rectangle(0, 0, 2, 1),
                                     rectangle(2, 0, 4, 1),
                                     rectangle(1, 1, 3, 2),
                                     rectangle(0.5, 0.5, 1, 0.75)};
  std::vector<Polygon> turned;
  for (auto block = wall.rbegin(); block != wall.rend(); ++block)
    turned.push_back(geometry::reversed(*block));
  const Soundness a = examine(wall), b = examine(turned);
  ASSERT_EQ(a.bad.size(), 1u);
  EXPECT_EQ(a.bad[0].block, 0);
  EXPECT_EQ(b.bad[0].block, 4);
  ASSERT_EQ(a.overlaps.size(), 1u);
  EXPECT_EQ(a.overlaps[0].first, 1);
  EXPECT_EQ(a.overlaps[0].second, 4);
  EXPECT_EQ(b.overlaps[0].first, 0);
  EXPECT_EQ(b.overlaps[0].second, 3);
  EXPECT_EQ(b.turned.size(), 4u);
  EXPECT_EQ(a.turned.size(), 0u);
  ASSERT_EQ(a.joints.t_junctions.size(), b.joints.t_junctions.size());
  for (const geometry::TJunction& one : a.joints.t_junctions)
    EXPECT_TRUE(std::any_of(b.joints.t_junctions.begin(), b.joints.t_junctions.end(),
                            [&](const geometry::TJunction& other) {
                              return other.block == 4 - one.block &&
                                     other.corner == one.corner &&
                                     other.other == 4 - one.other;
                            }));
}

}  // namespace
}  // namespace blocks::exchange
