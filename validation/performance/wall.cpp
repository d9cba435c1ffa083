#include "wall.hpp"

#include <stdexcept>
#include <vector>

namespace blocks::bench {
namespace {

constexpr double height = 0.5;  // of a row, [L]
constexpr double density = 2500.0;

NewBlock box(double left, double bottom, double right, double top, Fixity fixity) {
  return {
      {{left, bottom}, {left, top}, {right, top}, {right, bottom}}, 1, density, fixity};
}

Settings settings_of(double width, int rows) {
  Settings s;
  s.title = "WALL IN RUNNING BOND";
  s.lower = {-2, -2};
  s.upper = {width + 2, height * rows + 2};
  s.boxes_x = static_cast<int>(width) + 4;
  s.boxes_y = rows + 8;
  s.contact_tolerance = 0.05;
  s.normal_stiffness = s.shear_stiffness = 1e9;
  s.fraction = 0.025;
  s.damping = 0.5;
  s.friction = 0.6;
  s.gravity = {0, -9.81};
  s.rigid = true;
  s.materials[1] = {1e10, 4e9, density};
  return s;
}

}  // namespace

Model wall(int rows, int bricks) {
  if (rows <= 0 || rows % 2 != 0 || bricks <= 0)
    throw std::invalid_argument("a wall needs an even number of rows, and bricks");
  const double width = bricks, top = height * rows + 1;
  std::vector<NewBlock> blocks{box(-1, -1, width + 1, 0, Fixity::by_user),
                               box(-1, 0, 0, top, Fixity::by_user),
                               box(width, 0, width + 1, top, Fixity::by_user)};
  for (int column = 0; column <= bricks; ++column)
    for (int row = 0; row < rows; ++row) {
      const double y = height * row, x = column;
      if (row % 2 == 1)
        blocks.push_back(box(column == 0 ? 0.0 : x - 0.5, y,
                             column == bricks ? width : x + 0.5, y + height,
                             Fixity::free));
      else if (column < bricks)
        blocks.push_back(box(x, y, x + 1, y + height, Fixity::free));
    }
  Model model;
  model.settings = settings_of(width, rows);
  model.settings.max_blocks = static_cast<int>(blocks.size());
  model.settings.max_corners = 4;
  model.blocks.append(blocks);
  return model;
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
