// Blocks, sides and corners found by position.
#include "model/selection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace blocks {
namespace {

using ::testing::ElementsAre;

geometry::Polygon box(double x, double y) {
  return {{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}};
}

/// Two boxes side by side, one on top of the second, and an L whose notch holds none.
Blocks four() {
  Blocks blocks;
  blocks.append({{box(0, 0), 1, 1.0, Fixity::free, 0, {0, 0, 5, 0}},
                 {box(1, 0), 2, 1.0, Fixity::free, 0, {5, 0, 0, 0}},
                 {box(1, 1), 1, 1.0},
                 {{{4, 0}, {4, 2}, {5, 2}, {5, 1}, {6, 1}, {6, 0}}, 2, 1.0}});
  return blocks;
}

TEST(Selection, FindsTheBlockThatContainsAPoint) {
  const Blocks blocks = four();
  EXPECT_EQ(block_at(blocks, {0.5, 0.5}), 0);
  EXPECT_EQ(block_at(blocks, {1.5, 1.5}), 2);
  EXPECT_EQ(block_at(blocks, {4.5, 1.5}), 3);
  EXPECT_EQ(block_at(blocks, {5.5, 1.5}), -1);  // in its box, not in the block
}

// A point on common sides belongs to the lowest number; beside it by one unit in the
// last place, to the block there.
TEST(Selection, DecidesExactlyOnCommonSides) {
  Blocks blocks = four();
  EXPECT_EQ(block_at(blocks, {1.0, 0.5}), 0);
  EXPECT_EQ(block_at(blocks, {std::nextafter(1.0, 2.0), 0.5}), 1);
  EXPECT_EQ(block_at(blocks, {1.5, 1.0}), 1);
  EXPECT_EQ(block_at(blocks, {1.0, 1.0}), 0);
  blocks.fix(0, Fixity::removed);
  EXPECT_EQ(block_at(blocks, {1.0, 0.5}), 1);
}

TEST(Selection, FindsCentroidsInABoxWithItsSides) {
  const Blocks blocks = four();
  EXPECT_THAT(blocks_in(blocks, {2, 2}, {0.5, 0.5}), ElementsAre(0, 1, 2));
  EXPECT_THAT(blocks_in(blocks, {0.51, 0}, {2, 2}), ElementsAre(1, 2));
  EXPECT_THAT(blocks_of_material(blocks, 2), ElementsAre(1, 3));
}

TEST(Selection, FindsSidesByJointAndOnALine) {
  const Blocks blocks = four();
  EXPECT_THAT(sides_of_joint(blocks, 5), ElementsAre(BlockSide{0, 2}, BlockSide{1, 0}));
  EXPECT_THAT(sides_on(blocks, {1, 0}, {1, 2}, SidesOf::both),
              ElementsAre(BlockSide{0, 2}, BlockSide{1, 0}, BlockSide{2, 0}));
  EXPECT_THAT(sides_on(blocks, {1, 0}, {1, 2}, SidesOf::right),
              ElementsAre(BlockSide{1, 0}, BlockSide{2, 0}));
  EXPECT_THAT(sides_on(blocks, {1, 0}, {1, 2}, SidesOf::left),
              ElementsAre(BlockSide{0, 2}));
  EXPECT_THAT(sides_on(blocks, {1, 0.5}, {1, 2}, SidesOf::right),
              ElementsAre(BlockSide{2, 0}));
}

TEST(Selection, FindsTheNearestCorner) {
  const Blocks blocks = four();
  EXPECT_EQ(nearest_corner(blocks, {1.1, 0.9}), (BlockCorner{0, 2}));
  EXPECT_EQ(nearest_corner(blocks, {6.5, 1.5}), (BlockCorner{3, 4}));
  EXPECT_EQ(nearest_corner(Blocks(), {0, 0}).block, -1);
}

}  // namespace
}  // namespace blocks
