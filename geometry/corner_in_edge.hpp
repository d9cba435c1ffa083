// Tests whether a corner of one block lies inside an edge of another, up to rounding.
// It is the test of T-junctions and of T vertices, and it uses doubles only.
#pragma once

#include <cmath>
#include <cstddef>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Returns whether the corner is at most `reach` [L] from the line of an edge of the
/// block and between the ends of this edge. Returns false if the corner is at most
/// `reach` from a corner of the block, because the two then share that corner.
inline bool is_inside_an_edge(const Vec2& corner, const Polygon& block, double reach) {
  bool inside = false;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const Vec2& a = block[i];
    const Vec2 edge = block[i + 1 == block.size() ? 0 : i + 1] - a, to = corner - a;
    // Most corners are far from the line, and need no root. The second term is above
    // the rounding of the area, and the sum of the components above the length.
    if (std::abs(cross(edge, to)) >
        (4.0 * reach + 0x1p-50 * to.lpNorm<1>()) * edge.lpNorm<1>())
      continue;
    const double length = edge.stableNorm(), along = to.dot(edge) / length;
    if (to.norm() <= reach || (to - edge).norm() <= reach)
      return false;
    inside = inside || (0.0 < along && along < length &&
                        std::abs(cross(edge, to)) <= reach * length);
  }
  return inside;
}

}  // namespace blocks::geometry
