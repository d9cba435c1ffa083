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

/// The result of check_outline.
struct OutlineCheck {
  OutlineFault fault = OutlineFault::none;
  int first = -1;              ///< corner or side at fault, from 0; -1: none
  int second = -1;             ///< the other corner or side at fault, from 0; -1: none
  bool anticlockwise = false;  ///< simple, but with the wrong orientation
  bool convex = true;          ///< no corner is re-entrant
};

/// Checks an outline by exact predicates on the given doubles. A side folded back on
/// its neighbour (a spike) is reported as self_crossing, and corners that all lie on
/// one line as no_area.
OutlineCheck check_outline(const Polygon& outline);

/// Returns the fault in words, with corners and sides counted from 1: "sides 1 and 3
/// cross".
std::string describe(const OutlineCheck& check);

/// Returns the outline with the opposite orientation; corner 1 stays first.
Polygon reversed(const Polygon& outline);

/// Adds copy * shift to every corner exactly and rounds the sum once (CLOOP).
Polygon place_outline(const std::vector<DecimalPoint>& corners,
                      const DecimalPoint& shift, int copy);

/// Area [L^2], centroid [L], and second moments of area about the centroid [L^4].
struct SectionProperties {
  double area = 0.0;
  Vec2 centroid = Vec2::Zero();
  double polar_moment = 0.0;
  Eigen::Vector3d second_moment = Eigen::Vector3d::Zero();  ///< xx, xy, yy
};

/// Computes the properties of a simple clockwise outline. It uses differences to the
/// first corner, so it loses no digits far from the origin.
SectionProperties section_properties(const Polygon& outline);

/// Returns the smaller principal value of a second moment (xx, xy, yy), in its unit. In
/// a very thin block it is lost in round-off. It is at least `share` of the mean of
/// both.
double smaller_moment(const Eigen::Vector3d& second_moment, double share);

}  // namespace blocks::geometry
