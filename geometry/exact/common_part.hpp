// PRIVATE to geometry/: what two convex outlines have in common, when it is so thin
// that doubles would tell nothing of it.
#pragma once

#include "geometry/vec2.hpp"

namespace blocks::geometry::exact {

/// Figures of a common part, calculated exactly up to the last roundings.
struct CommonPart {
  double area = 0.0;          ///< [L^2]; 0 when it is below the smallest double
  Vec2 place = Vec2::Zero();  ///< [L] its centroid
  double depth = 0.0;         ///< [L] shortest shift that separates the two
};

/// p, q: convex and clockwise, their interiors meet.
CommonPart common_part(const Polygon& p, const Polygon& q);

}  // namespace blocks::geometry::exact
