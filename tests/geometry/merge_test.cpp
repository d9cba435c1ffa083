#include <gtest/gtest.h>

#include "geometry/exact/merge.hpp"
#include "layers.hpp"

namespace blocks::geometry {
namespace {

using exact::Rational;

/// The sides of a layer of height 1, relative to its length.
struct Widths {
  std::vector<Rational> sides{Rational(0)};
  Rational length;
};
/// Returns the sides of blocks with these widths in tenths.
Widths tenths(const std::vector<int>& widths) {
  Widths result;
  for (const int w : widths)
    result.length += Rational(w, 10);
  Rational sum(0);
  for (const int w : widths) {
    sum += Rational(w, 10);
    result.sides.push_back(sum / result.length);
  }
  return result;
}

std::vector<Absorption> merged(const std::vector<int>& widths, const char* ratio,
                               std::vector<std::size_t>& kept) {
  const Widths w = tenths(widths);
  std::vector<Absorption> record;
  kept = exact::merge_slender(w.sides, w.length,
                              exact::rational(testing::decimal(ratio)), record);
  return record;
}

TEST(Merge, KeepsABlockOfExactlyTheRatio) {
  // Three blocks of 0.2 are in a length of 0.6. In doubles 0.6 / 3 < 0.2.
  std::vector<std::size_t> kept;
  EXPECT_TRUE(merged({2, 2, 2}, "0.2", kept).empty());
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(merged({2, 2, 2}, "0.20000000000000000000001", kept).size(), 2U);
}

TEST(Merge, MergesASlenderBlockIntoTheNextOnTheRight) {
  std::vector<std::size_t> kept;
  const auto record = merged({9, 2, 3, 4, 9}, "0.6", kept);
  ASSERT_EQ(record.size(), 2U);
  EXPECT_EQ(record[0].absorbed, 2);
  EXPECT_EQ(record[0].into, 3);
  EXPECT_EQ(record[0].width_to_height, 0.2);
  EXPECT_EQ(record[1].absorbed, 3);
  EXPECT_EQ(record[1].into, 4);
  EXPECT_EQ(record[1].width_to_height,
            0.5);  // This is the width after it has absorbed block 2.
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 1, 4, 5}));
}

TEST(Merge, MergesTheLastBlockIntoItsLeftNeighbour) {
  std::vector<std::size_t> kept;
  const auto record = merged({9, 9, 2, 3}, "0.6", kept);
  ASSERT_EQ(record.size(), 2U);
  EXPECT_EQ(record[0].into, 4);
  EXPECT_EQ(record[1].absorbed, 4);
  EXPECT_EQ(record[1].into, 2);
  EXPECT_EQ(record[1].width_to_height, 0.5);
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 1, 4}));
}

TEST(Merge, KeepsASingleSlenderBlock) {
  std::vector<std::size_t> kept;
  EXPECT_TRUE(merged({5}, "0.6", kept).empty());
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 1}));
}

TEST(Merge, LeavesNoSlenderBlockAndNoUnusedVertex) {
  LayerRequest request = testing::random_layer("0 0 0 1 100 1 100 0", 120);
  request.merge_ratio = testing::decimal("0.7");
  const Layer after = cut_layer(request);
  ASSERT_FALSE(after.absorptions.empty());
  EXPECT_EQ(after.mesh.cells.size() + after.absorptions.size(), 120U);
  EXPECT_EQ(after.mesh.vertices.size(), 2 * (after.mesh.cells.size() + 1));
  for (std::size_t i = 0; i < after.mesh.cells.size(); ++i) {
    const auto c = testing::cell(after, i);
    EXPECT_GE(c[3].x() - c[0].x(), 0.7 - 1e-13);
  }
}

TEST(Merge, DoesNotMoveTheSidesThatRemain) {
  LayerRequest request = testing::random_layer("0 0 0 1 100 1 100 0", 120);
  const Layer before = cut_layer(request);
  request.merge_ratio = testing::decimal("0.7");
  const Layer after = cut_layer(request);
  ASSERT_FALSE(after.absorptions.empty());
  for (const Vec2& v : after.mesh.vertices) {
    EXPECT_NE(std::find(before.mesh.vertices.begin(), before.mesh.vertices.end(), v),
              before.mesh.vertices.end());
  }
}

}  // namespace
}  // namespace blocks::geometry
