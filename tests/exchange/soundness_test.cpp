// Findings of import about outlines that do not fit together.
#include "exchange/soundness.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace blocks::exchange {
namespace {

using geometry::Polygon;

Polygon rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {left, top}, {right, top}, {right, bottom}};
}

// A brick is on two others. Its two lower corners are on their upper sides, and the
// corner that the two share is on its lower side.
TEST(Soundness, FindsTJunctionsOfABrickWall) {
  const Soundness wall =
      examine({rectangle(0, 0, 2, 1), rectangle(2, 0, 4, 1), rectangle(1, 1, 3, 2)});
  EXPECT_TRUE(wall.sound());
  EXPECT_TRUE(wall.joints.slits.empty());
  EXPECT_EQ(wall.joints.t_junctions.size(),
            4u);  // The shared corner counts for both bricks.
}

TEST(Soundness, FindsNoTJunctionAtSharedCorners) {
  const Soundness pair = examine({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)});
  EXPECT_TRUE(pair.sound());
  EXPECT_TRUE(pair.joints.t_junctions.empty());
  EXPECT_TRUE(pair.joints.slits.empty());
}

// Import never moves such blocks together.
TEST(Soundness, FindsSlitsBetweenBlocksThatNearlyMeet) {
  const double hair = 0x1p-40;
  const Soundness pair = examine({rectangle(0, 0, 1, 1), rectangle(1 + hair, 0, 2, 1)});
  EXPECT_TRUE(pair.sound());
  ASSERT_EQ(pair.joints.slits.size(), 1u);
  EXPECT_EQ(pair.joints.slits[0].first, 0);
  EXPECT_EQ(pair.joints.slits[0].second, 1);
  EXPECT_EQ(pair.joints.slits[0].width, hair);
}

// Users cannot correct an overlap of one unit in the last place.
TEST(Soundness, DistinguishesRoundingFromOverlap) {
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

// The triangle is so slender that its length over its height exceeds any integer type.
TEST(Soundness, AcceptsExtremelySlenderShapes) {
  const Soundness needle = examine({{{0, 0}, {1, 1}, {1e99, 0}}});
  EXPECT_TRUE(needle.sound());
  EXPECT_TRUE(needle.joints.t_junctions.empty());
}

// Only block numbers depend on the order. Faulty outlines count for these numbers.
TEST(Soundness, DoesNotDependOnSenseOrOrder) {
  const std::vector<Polygon> wall = {
      {{9, 9}, {10, 10}, {10, 9}, {9, 10}},  // This is a bow-tie.
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
