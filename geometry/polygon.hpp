// Builds and checks one block outline (CREATE, CLOOP, READ9; report A.2.1,
// docs/departures.md#create-and-cloop).
#pragma once

#include <string>

#include "geometry/decimal.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

enum class OutlineFault {
  none,
  too_few_corners,
  not_finite,
  repeated_corner,
  no_area,
  self_crossing
};

/// What exact predicates say of an outline.
struct OutlineCheck {
  OutlineFault fault = OutlineFault::none;
  int first = -1;   ///< corner or side concerned, from 0 (-1: none)
  int second = -1;  ///< the other corner or side concerned, from 0 (-1: none)
  bool anticlockwise = false;  ///< simple, but in the wrong sense
  bool convex = true;          ///< no corner turns the wrong way
};

/// Checks an outline by exact predicates on the given doubles. A side folded back on
/// its neighbour (a spike) counts as self_crossing, all corners on one line as no_area.
OutlineCheck check_outline(const Polygon& outline);

/// The fault in words, corners and sides counted from 1: "sides 1 and 3 cross".
std::string describe(const OutlineCheck& check);

/// The same outline in the other sense; corner 1 stays first.
Polygon reversed(const Polygon& outline);

/// Adds copy * shift to every corner exactly and rounds once (CLOOP).
Polygon place_outline(const std::vector<DecimalPoint>& corners,
                      const DecimalPoint& shift, int copy);

/// Area [L^2], centroid [L] and polar second moment of area about the centroid [L^4].
struct SectionProperties {
  double area = 0.0;
  Vec2 centroid = Vec2::Zero();
  double second_moment = 0.0;
};

/// Properties of a simple clockwise outline, computed from differences to its first
/// corner so that they do not lose digits far from the origin.
SectionProperties section_properties(const Polygon& outline);

}  // namespace blocks::geometry
