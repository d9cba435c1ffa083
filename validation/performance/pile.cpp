#include "pile.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/random.hpp"

namespace blocks::bench {
namespace {

constexpr double density = 2500.0;
constexpr int layers = 10;

/// Uniform in [low, high), for draw `draw` of polygon `number`.
double uniform(int number, std::uint32_t draw, double low, double high) {
  const auto bits =
      geometry::random_53_bits({1982, 0}, static_cast<std::uint64_t>(number), draw, 0);
  return low + (high - low) * static_cast<double>(bits) * 0x1p-53;
}

/// Corners on a circle at uneven angles: convex whatever the angles are.
geometry::Polygon polygon(int number, const Vec2& centre) {
  const int corners = 4 + static_cast<int>(uniform(number, 0, 0, 5));
  const double radius = uniform(number, 1, 0.4, 0.5);
  const double part = 2.0 * std::numbers::pi / corners;
  const double start = uniform(number, 2, 0, part);
  geometry::Polygon outline;
  for (int k = 0; k < corners; ++k) {
    const double angle =
        start - part * (k + uniform(number, static_cast<std::uint32_t>(3 + k), 0, 0.6));
    outline.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

NewBlock fixed_box(double left, double bottom, double right, double top) {
  return {{{left, bottom}, {left, top}, {right, top}, {right, bottom}},
          1,
          density,
          Fixity::by_user};
}

}  // namespace

Model loose_pile(int polygons) {
  const int columns = (polygons + layers - 1) / layers;
  const double width = columns, top = layers + 2;
  std::vector<NewBlock> blocks{fixed_box(-1, -1, width + 1, 0),
                               fixed_box(-1, 0, 0, top),
                               fixed_box(width, 0, width + 1, top)};
  for (int i = 0; i < polygons; ++i)
    blocks.push_back(
        {polygon(i, Vec2(i / layers + 0.5, i % layers + 0.5)), 1, density});
  Model model;
  Settings& s = model.settings;
  s.title = "PILE OF RANDOM POLYGONS";
  s.max_blocks = static_cast<int>(blocks.size());
  s.max_corners = 8;
  s.lower = {-2, -2};
  s.upper = {width + 2, top + 2};
  s.boxes_x = columns + 4;
  s.boxes_y = layers + 6;
  s.contact_tolerance = 0.05;
  s.normal_stiffness = s.shear_stiffness = 1e8;
  s.fraction = 0.025;
  s.damping = 0.5;
  s.friction = 0.6;
  s.gravity = {0, -9.81};
  s.rigid = true;
  s.materials[1] = {1e10, 4e9, density};
  model.blocks.append(blocks);
  return model;
}

}  // namespace blocks::bench
