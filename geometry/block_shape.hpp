// Shape measures of a block, to judge a layering or an imported mesh before a run. The
// values are computed in doubles for a report; no decision depends on them.
#pragma once

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Measures of one simple clockwise outline.
struct BlockShape {
  double area = 0.0;           ///< [L^2] > 0
  double aspect = 1.0;         ///< >= 1: ratio of the long to the short side of the
                               ///< rectangle with the same second moments of area
  double shortest_edge = 0.0;  ///< [L]
  int edge = 0;  ///< index of the shortest edge, which starts at this corner
  double smallest_angle = 0.0;  ///< degrees, between the two edges of a corner
  int corner = 0;               ///< index of the corner with the smallest angle
};

/// Measures an outline. It uses differences of corners, so it loses no digits far from
/// the origin. Guarantees: translation, rotation and renumbering of the corners change
/// the result by round-off only. A rectangle a x b with a >= b has aspect a/b. Scaling
/// keeps aspect and angle.
BlockShape measure_shape(const Polygon& outline);

/// Returns the largest distance between neighbouring doubles among the coordinates,
/// [L], or 0 without corners. Its ratio to the shortest edge tells how finely positions
/// are resolved.
double coarsest_ulp(const Polygon& outline);

}  // namespace blocks::geometry
