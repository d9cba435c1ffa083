// The estimated number of pairs in a contact list.
#include "run/support/contact_memory.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tools/rectangle.hpp"

namespace blocks::run {
namespace {

using testing::rectangle;

// Block 1 is the floor, which is near many bricks and so no typical sample.
TEST(LikelyList, HasNearlyTheNumberOfPairsOfAWall) {
  constexpr int columns = 5000, rows = 3;
  std::vector<NewBlock> wall = {rectangle(0.0, -1.0, columns, 1.0)};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      wall.push_back(rectangle(column, 0.5 * row, 1.0, 0.5));
  Blocks blocks;
  blocks.append(wall);
  // Pairs are beside each other, above each other (three for a brick), and on the
  // floor.
  const double pairs = (columns - 1.0) * rows + (3.0 * columns - 2.0) * (rows - 1.0) +
                       static_cast<double>(columns);
  const LikelyList list = likely_list(blocks, 1e-3);
  EXPECT_GT(list.pairs, 0.8 * pairs);
  EXPECT_LT(list.pairs, 1.2 * pairs);
}

}  // namespace
}  // namespace blocks::run
