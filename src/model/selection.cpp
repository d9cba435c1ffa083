#include "model/selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/region.hpp"

namespace blocks {
namespace {

/// Returns whether the point is in the box around the corners of block b.
bool box_contains(const Blocks& blocks, int b, const Vec2& point) {
  const auto corners =
      blocks.corner.middleCols(blocks.first_corner[b], blocks.corners_of(b));
  return (corners.rowwise().minCoeff().array() <= point.array()).all() &&
         (corners.rowwise().maxCoeff().array() >= point.array()).all();
}

template <class Matches>
std::vector<BlockSide> matching_sides(const Blocks& blocks, const Matches& matches) {
  std::vector<BlockSide> found;
  for (int c = 0; c < blocks.corners(); ++c) {
    const int b = blocks.corner_block[c];
    if (!blocks.is_removed(b) && matches(c))
      found.push_back({b, c - blocks.first_corner[b]});
  }
  return found;
}

}  // namespace

int block_at(const Blocks& blocks, const Vec2& point) {
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.is_removed(b) && box_contains(blocks, b, point) &&
        geometry::Region(blocks.outline(b)).contains(point))
      return b;
  return -1;
}

std::vector<int> blocks_in(const Blocks& blocks, const Vec2& corner,
                           const Vec2& opposite) {
  const Vec2 lower = corner.cwiseMin(opposite), upper = corner.cwiseMax(opposite);
  std::vector<int> found;
  for (int b = 0; b < blocks.size(); ++b) {
    const Vec2 centroid = blocks.centroid.col(b);
    if (!blocks.is_removed(b) && (lower.array() <= centroid.array()).all() &&
        (centroid.array() <= upper.array()).all())
      found.push_back(b);
  }
  return found;
}

std::vector<int> blocks_of_material(const Blocks& blocks, int material) {
  std::vector<int> found;
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.is_removed(b) && blocks.material[b] == material)
      found.push_back(b);
  return found;
}

std::vector<BlockSide> sides_of_joint(const Blocks& blocks, int id) {
  return matching_sides(blocks, [&](int c) { return blocks.joint[c] == id; });
}

std::vector<BlockSide> sides_on(const Blocks& blocks, const Vec2& a, const Vec2& b,
                                SidesOf which, double tolerance) {
  constexpr double rounding_part = 1e-9;
  const Vec2 line = b - a;
  const double length = line.norm(),
               reach = std::max(rounding_part * length, tolerance);
  if (!(length > 0.0))
    return {};
  const Vec2 along = line / length;
  const auto is_on = [&](int c) {
    const Vec2 from = blocks.corner.col(c) - a;
    const double t = along.dot(from);
    return std::abs(geometry::cross(along, from)) <= reach && t >= -reach &&
           t <= length + reach;
  };
  return matching_sides(blocks, [&](int c) {
    const int end = blocks.next[c];
    if (!is_on(c) || !is_on(end))
      return false;
    // Corners are clockwise, so the block is on the right of its side.
    const bool same_way =
        along.dot(Vec2(blocks.corner.col(end) - blocks.corner.col(c))) > 0.0;
    return which == SidesOf::both || same_way == (which == SidesOf::right);
  });
}

BlockCorner nearest_corner(const Blocks& blocks, const Vec2& point) {
  BlockCorner nearest;
  double min = std::numeric_limits<double>::infinity();
  for (int c = 0; c < blocks.corners(); ++c) {
    const int b = blocks.corner_block[c];
    const double square = (blocks.corner.col(c) - point).squaredNorm();
    if (!blocks.is_removed(b) && square < min) {
      min = square;
      nearest = {b, c - blocks.first_corner[b]};
    }
  }
  return nearest;
}

}  // namespace blocks
