// PRIVATE to geometry/: the intersection of two convex outlines that is too thin to be
// computed in doubles.
#pragma once

#include "geometry/vec2.hpp"

namespace blocks::geometry::exact {

/// Measures of the intersection, exact up to the last roundings.
struct CommonPart {
  double area = 0.0;          ///< [L^2]; 0 if below the smallest double
  Vec2 place = Vec2::Zero();  ///< [L] centroid of the intersection
  double depth = 0.0;         ///< [L] shortest translation that separates the two
};

/// Intersects p and q, which must be convex and clockwise with intersecting interiors.
CommonPart common_part(const Polygon& p, const Polygon& q);

}  // namespace blocks::geometry::exact
