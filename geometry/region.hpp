// Tests whether blocks lie inside an outline. REMOVE and FREE also accept a block that
// is inside once it is shrunk by 1e-9 of its size, because moved corners are rounded.
#pragma once

#include <Eigen/Geometry>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// The closed region that a simple outline bounds.
class Region {
 public:
  /// outline: simple, clockwise or anticlockwise, [L].
  explicit Region(Polygon outline);

  /// Returns whether a simple polygon, [L], lies entirely inside. The decision is exact
  /// for the given doubles. Corners and sides that touch the outline count as inside. A
  /// polygon with a corner that is not finite is not inside.
  bool contains(const Polygon& polygon) const;
  /// Returns whether a point, [L], is inside or on the outline, decided exactly.
  bool contains(const Vec2& point) const;

 private:
  bool contains_side(const Vec2& from, const Vec2& to) const;

  Polygon outline_;
  Eigen::AlignedBox2d box_;
};

}  // namespace blocks::geometry
