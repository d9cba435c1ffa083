// How well shaped a block is: what a user wants to know of a layering or an imported
// mesh before running it. Figures for a report, in doubles; decides nothing.
#pragma once

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Measures of one simple clockwise outline.
struct BlockShape {
  double area = 0.0;            ///< [L^2] > 0
  double aspect = 1.0;          ///< >= 1: long to short side of the rectangle with the
                                ///< same second moments of area
  double shortest_edge = 0.0;   ///< [L]
  int edge = 0;                 ///< where: from this corner, from 0, to the next
  double smallest_angle = 0.0;  ///< degrees, between the two edges of a corner
  int corner = 0;               ///< where, from 0
};

/// Measures an outline, from differences of its corners so that nothing is lost far
/// from the origin. Laws: moving, turning and renumbering change nothing but round-off;
/// a rectangle a x b, a >= b, has aspect a/b, and scaling keeps aspect and angle.
BlockShape measure_shape(const Polygon& outline);

/// The largest distance between neighbouring doubles among the coordinates, [L]; 0
/// without corners. Over the shortest edge it says how finely positions are resolved.
double coarsest_ulp(const Polygon& outline);

}  // namespace blocks::geometry
