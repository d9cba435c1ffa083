// The two basic types that all folders share: a point in the plane and a block outline.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace blocks::geometry {

/// A point or a vector in the plane, [L].
using Vec2 = Eigen::Vector2d;

/// Corners of a block outline, [L]: clockwise, not closed (the last corner differs from
/// the first). Side i runs from corner i to corner i + 1.
using Polygon = std::vector<Vec2>;
/// The largest number of corners of a block.
inline constexpr int max_corners = 32767;

/// z component of a x b: positive when b is anticlockwise of a.
inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace blocks::geometry
