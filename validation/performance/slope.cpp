#include "slope.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "masonry.hpp"

namespace blocks::bench {
namespace {

constexpr double angle = 20.0 * std::numbers::pi / 180.0;
constexpr int layers = 4;
// The layers have 280, 260, 240 and 220 bricks.
constexpr int longest = 280, shorter = 20;
constexpr double height = 0.5;  // [L] height of a layer
// [L] A layer begins this far behind the start of the one below and ends as far before
// its end, because it slides. The half makes a running bond.
constexpr double shift = 10.5;
// [L] Length of a piece of the floor, and of the floor before and after the bricks.
constexpr double piece = 20.0, before = 20.0, after = 500.0;

/// Inclines an upright block. The floor starts at x = 0 and ends at y = 0.
NewBlock inclined(NewBlock block) {
  const double fall = (longest + after) * std::sin(angle);
  for (Vec2& p : block.outline)
    p = {std::cos(angle) * (p.x() + before) + std::sin(angle) * p.y(),
         fall - std::sin(angle) * p.x() + std::cos(angle) * p.y()};
  return block;
}

}  // namespace

Model sliding_slope() {
  std::vector<NewBlock> blocks;
  for (double x = -before; x < longest + after; x += piece)
    blocks.push_back(inclined(box(x, -1, x + piece, 0, Fixity::by_user)));
  const auto floor = blocks.size();
  std::vector<double> speed;
  for (int layer = 0; layer < layers; ++layer)
    for (int i = 0; i < longest - shorter * layer; ++i) {
      const double x = shift * layer + i, y = height * layer;
      blocks.push_back(inclined(box(x, y, x + 1, y + height)));
      speed.push_back(layer + 1);
    }
  const double length = before + longest + after;
  const double rise = length * std::sin(angle) + height * layers + 1;
  Model model = masonry("SLIDING SLOPE", blocks, length * std::cos(angle) + 1, rise,
                        static_cast<int>(rise) + 4, 1e9);
  model.settings.friction = 0.2;
  for (std::size_t i = 0; i < speed.size(); ++i)
    model.blocks.velocity.col(static_cast<Eigen::Index>(floor + i))
        << speed[i] * std::cos(angle),
        -speed[i] * std::sin(angle);
  return model;
}

}  // namespace blocks::bench
