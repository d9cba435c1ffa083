// Random fixed domains, and random joints that cut them into pieces. Independent of
// blocks in motion.
#pragma once

#include <string>
#include <vector>

#include "geometry/vec2.hpp"
#include "study/draws.hpp"

namespace blocks::study {

using geometry::Polygon;
using geometry::Vec2;

/// The size of the moving blocks is 1, so all lengths are in block sizes.
inline constexpr double min_width = 0.05;  ///< of a piece, see narrowest_width
inline constexpr double min_angle = 10.0;  ///< of a corner of a piece, degrees

/// A fixed domain and the pieces into which joints cut it.
struct CutDomain {
  std::string kind;     ///< "flat", "ridge", "notch", ...
  Polygon outline;      ///< clockwise; begins with the surface, from left to right
  int surface = 0;      ///< number of corners of the outline that are on its surface
  double sharpest = 0;  ///< half the angle of the sharpest re-entrant corner, rad; pi/2
                        ///< if there is none
  std::vector<Polygon> pieces;  ///< flush; together they fill the outline
  std::vector<Vec2> ends;       ///< points of the surface at which joints end
  int joints = 0;
};

/// The names of the kinds of domains.
const std::vector<std::string>& domain_kinds();

/// Draws a domain of this kind without joints: one piece.
CutDomain draw_domain(Draws& draw, const std::string& kind);

/// Cuts the domain by so many random joints. A joint that would leave a piece too
/// narrow or too pointed is not cut in this piece.
void cut_domain(Draws& draw, int joints, CutDomain& domain);

/// Returns the outline with a straight corner at every end of a joint on its surface.
Polygon marked_outline(const CutDomain& domain);

/// Returns the side of the surface on which a point is, counted from 0, or -1.
int surface_side(const CutDomain& domain, const Vec2& point);

/// Returns the shortest of all sides and of the distances from a corner to a side that
/// does not contain it, [L].
double narrowest_width(const Polygon& piece);

/// Returns the smallest interior angle, in degrees.
double sharpest_angle(const Polygon& piece);

}  // namespace blocks::study
