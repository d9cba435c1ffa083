#include "wall.hpp"

#include <stdexcept>
#include <vector>

#include "masonry.hpp"

namespace blocks::bench {
namespace {

constexpr double height = 0.5;  // of a row, [L]

}  // namespace

Model wall(int rows, int bricks) {
  if (rows <= 0 || rows % 2 != 0 || bricks <= 0)
    throw std::invalid_argument("a wall needs an even number of rows, and bricks");
  const double width = bricks, high = height * rows;
  std::vector<NewBlock> blocks = trough(width, high + 1);
  for (int column = 0; column <= bricks; ++column)
    for (int row = 0; row < rows; ++row) {
      const double y = height * row, x = column;
      if (row % 2 == 1)
        blocks.push_back(box(column == 0 ? 0.0 : x - 0.5, y,
                             column == bricks ? width : x + 0.5, y + height));
      else if (column < bricks)
        blocks.push_back(box(x, y, x + 1, y + height));
    }
  return masonry("WALL IN RUNNING BOND", blocks, width, high, rows + 8, 1e9);
}

Model wall_of_power(int power) {
  if (power < 1 || power > 7)
    throw std::invalid_argument("a wall has 10 to 10,000,000 blocks");
  int fives = 1;
  for (int i = 0; i < power; ++i)
    fives *= 5;
  return wall(2 << power, (fives - 1) / 2);
}

}  // namespace blocks::bench
