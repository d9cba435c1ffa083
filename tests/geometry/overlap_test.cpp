#include "geometry/overlap.hpp"

#include <gtest/gtest.h>

#include "layers.hpp"

namespace blocks::geometry {
namespace {

Polygon square(double x, double y, double size = 1.0) {
  return {{x, y}, {x, y + size}, {x + size, y + size}, {x + size, y}};
}

TEST(BlockOverlap, IsNotFoundForBlocksThatTouch) {
  const Polygon l = {{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}};
  EXPECT_TRUE(overlapping_pairs({square(0, 0), square(1, 0), square(1, 1)}).empty());
  EXPECT_TRUE(overlapping_pairs({l, square(1, 1), square(2, 1)}).empty());
}

TEST(BlockOverlap, IsFoundForOneUlp) {
  const double x = std::nextafter(1.0, 0.0);
  const auto pairs = overlapping_pairs({square(0, 0), square(x, 0)});
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].first, 0);
  EXPECT_EQ(pairs[0].second, 1);
}

// The tip of a wedge is h below a side, so that the depth is h and the area h^2. The
// differences of rounded corners would leave no digit of them.
TEST(BlockOverlap, HasAllDigitsOfAThinOverlap) {
  for (const double at : {0.0, 1000.0})
    for (const double h : {0x1p-20, at > 0.0 ? 0x1p-43 : 0x1p-52}) {
      const double y = at + 1.0 - h;
      const auto pairs = overlapping_pairs(
          {square(at, at), {{at + 0.5, y}, {at - 0.5, y + 1.0}, {at + 1.5, y + 1.0}}});
      ASSERT_EQ(pairs.size(), 1U);
      EXPECT_EQ(pairs[0].area, h * h) << at;
      EXPECT_EQ(pairs[0].depth, h) << at;
      EXPECT_NEAR(pairs[0].place.y(), y, h) << at;
    }
}

TEST(BlockOverlap, IsPositiveIfItsAreaIsBelowTheSmallestDouble) {
  const double h = 0x1p-600;
  const auto pairs = overlapping_pairs({square(-1, -1), square(-h, -h)});
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(positive_text(pairs[0].area, 6), "less than 5e-324");
  EXPECT_EQ(pairs[0].depth, h);
}

TEST(PositiveText, OfASmallDoubleHasItsDigits) {
  EXPECT_EQ(positive_text(0x1p-106, 6), "1.2326e-32");
}

TEST(BlockOverlap, HasAreaAndPlaceOfTheIntersection) {
  const auto pairs = overlapping_pairs({square(9, 9), square(1, 0.5), square(0.5, 0)});
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].first, 1);
  EXPECT_EQ(pairs[0].second, 2);
  EXPECT_DOUBLE_EQ(pairs[0].area, 0.25);
  EXPECT_EQ(pairs[0].place, Vec2(1.25, 0.75));
}

TEST(BlockOverlap, IsFoundForOutlinesThatAreNotConvex) {
  const Polygon comb = {{0, 0}, {0, 3}, {1, 3}, {1, 1}, {2, 1}, {2, 3}, {3, 3}, {3, 0}};
  const auto inside = overlapping_pairs({comb, square(1.25, 1.5, 0.5)});
  EXPECT_TRUE(inside.empty());  // The square is between the teeth.
  const Polygon beam = {{-1, 2}, {-1, 2.5}, {4, 2.5}, {4, 2}};
  const auto crossing = overlapping_pairs({comb, beam});
  ASSERT_EQ(crossing.size(), 1U);
  EXPECT_DOUBLE_EQ(crossing[0].area, 1.0);
}

TEST(BlockOverlap, IsFoundForContainedAndIdenticalOutlines) {
  const Polygon comb = {{0, 0}, {0, 3}, {1, 3}, {1, 1}, {2, 1}, {2, 3}, {3, 3}, {3, 0}};
  const auto same = overlapping_pairs({comb, comb});
  ASSERT_EQ(same.size(), 1U);
  EXPECT_DOUBLE_EQ(same[0].area, 7.0);
  EXPECT_EQ(overlapping_pairs({square(0, 0, 4), square(1, 1)}).size(), 1U);
}

TEST(BlockOverlap, IsNotFoundForTheCellsOfALayer) {
  const Layer layer = cut_layer(
      testing::random_layer("0 0 -1.3 3.1 81.7 30.3 80.1 24.9", 40, "-30", "30"));
  std::vector<Polygon> outlines;
  for (const auto& cell : layer.mesh.cells)
    outlines.push_back(testing::outline_of(layer.mesh, cell));
  EXPECT_TRUE(overlapping_pairs(outlines).empty());
}

}  // namespace
}  // namespace blocks::geometry
