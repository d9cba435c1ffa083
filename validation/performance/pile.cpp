#include "pile.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/random.hpp"
#include "masonry.hpp"

namespace blocks::bench {
namespace {

constexpr int layers = 10;

/// Returns a uniform number in [low, high) for draw `draw` of polygon `number`.
double uniform(int number, std::uint32_t draw, double low, double high) {
  const auto bits =
      geometry::random_53_bits({1982, 0}, static_cast<std::uint64_t>(number), draw, 0);
  return low + (high - low) * static_cast<double>(bits) * 0x1p-53;
}

/// Returns a polygon with corners on a circle at irregular angles. It is always convex.
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

}  // namespace

Model loose_pile(int polygons) {
  const int columns = (polygons + layers - 1) / layers;
  const double width = columns, top = layers + 2;
  std::vector<NewBlock> blocks = trough(width, top);
  for (int i = 0; i < polygons; ++i)
    blocks.push_back(
        {polygon(i, Vec2(i / layers + 0.5, i % layers + 0.5)), 1, rock_density});
  return masonry("PILE OF RANDOM POLYGONS", blocks, width, top, layers + 6, 1e8);
}

}  // namespace blocks::bench
