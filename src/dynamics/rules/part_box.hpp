// The bounding box of a part at the present positions.
#pragma once

#include "dynamics/rules/block_parts.hpp"
#include "geometry/vec2.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

struct PartBox {
  geometry::Vec2 lower, upper;

  PartBox(const geometry::Vec2& from, const geometry::Vec2& to)
      : lower(from), upper(to) {}
  PartBox(const Blocks& blocks, const BlockParts& parts, int part)
      : lower(blocks.corner.col(parts.corner(part, 0))), upper(lower) {
    for (int i = 1; i < parts.corners(part); ++i) {
      const geometry::Vec2 corner = blocks.corner.col(parts.corner(part, i));
      lower = lower.cwiseMin(corner), upper = upper.cwiseMax(corner);
    }
  }
  /// Returns whether two boxes have a point in common, borders included.
  bool meets(const PartBox& other) const {
    return (lower.array() <= other.upper.array()).all() &&
           (other.lower.array() <= upper.array()).all();
  }
  /// Returns the box grown by so many times the sum of its extents.
  PartBox grown(double times) const {
    const double growth = times * (upper - lower).sum();
    return {lower.array() - growth, upper.array() + growth};
  }
};

}  // namespace blocks::dynamics
