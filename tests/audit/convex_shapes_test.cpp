// Lengths, overlaps and slides of convex polygons with known values.
#include "audit/convex_shapes.hpp"

#include <gtest/gtest.h>

namespace blocks::audit {
namespace {

Shape box(int x, int y, int w, int h) {
  return {{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}};
}

TEST(Length, IsComparedBySignAndSquare) {
  const Length root2{2, 2}, less{7, 25}, zero{0, 3};  // sqrt(2), 1.4, 0
  EXPECT_TRUE(less < root2);
  EXPECT_TRUE(-root2 < -less);
  EXPECT_TRUE(-less < zero && zero < less);
  EXPECT_TRUE((Length{4, 8} <=> root2) == 0);
  EXPECT_TRUE(root2 / 2 < less);
  EXPECT_TRUE(less < Dyadic(1.5) * less);
}

TEST(Length, IsRoundedToADouble) {
  Lattice lattice;
  lattice.include(0.25);
  EXPECT_DOUBLE_EQ(lattice.rounded(Length{2, 2}), 0.25 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(lattice.rounded(Length{-(Whole(3) << 2000), Whole(8) << 3999}),
                   -0.75 / 2.0);
  EXPECT_DOUBLE_EQ(rounded(Ratio{1, 3}), 1.0 / 3.0);
}

TEST(ConvexShapes, OverlapOfTwoBoxes) {
  const Shape one = box(0, 0, 10, 10), other = box(7, 6, 10, 10);
  EXPECT_TRUE((separating_shift(one, other) <=> Length{3, 1}) == 0);
  EXPECT_TRUE((common_diameter(one, other) <=> Length{5, 1}) == 0);
  EXPECT_TRUE((common_diameter(one, box(10, 2, 9, 3)) <=> Length{3, 1}) == 0);
  EXPECT_EQ(sign(common_diameter(one, box(11, 2, 9, 3)).n), 0);
  EXPECT_TRUE((longest_side(box(0, 0, 3, 4)) <=> Length{4, 1}) == 0);
}

TEST(ConvexShapes, ASideCrossesWithASegmentOfPositiveLength) {
  const Shape shape = box(0, 0, 10, 10);
  EXPECT_TRUE(crosses({{-5, 5}, {6, 0}}, shape));
  EXPECT_FALSE(crosses({{-5, 5}, {5, 0}}, shape)) << "it ends on the border";
  EXPECT_TRUE(crosses({{-5, 10}, {20, 0}}, shape)) << "it runs along the border";
  EXPECT_FALSE(crosses({{-5, 5}, {10, 10}}, shape)) << "it touches a corner";
}

TEST(ConvexShapes, ASlideEndsWhereTheShapesTouch) {
  const Shape moving = box(7, 6, 10, 10), resting = box(0, 0, 10, 10);
  EXPECT_TRUE((way_out(moving, {1, 0}, resting) <=> Ratio{3}) == 0);
  EXPECT_TRUE((way_out(moving, {-2, 0}, resting) <=> Ratio{17, 2}) == 0);
  EXPECT_TRUE((way_out(moving, {1, 2}, resting) <=> Ratio{2}) == 0);
}

}  // namespace
}  // namespace blocks::audit
