// Decides which contacts are too deep for the region that two convex polygons have in
// common, and whether a side has a segment in another polygon
// (docs/contact-rule.md#overlap-region). The answers are exact for the stored doubles.
// The contact rule uses bounds in doubles first
// (src/dynamics/rules/overlap_region.hpp).
#pragma once

#include <span>

#include "geometry/contact_constants.hpp"
#include "geometry/covered_side.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry::exact {

/// Returns whether corner c is far below the line p1 p2: its depth, less contact_slack
/// times the length of p1 p2, is more than far_factor times the depth of corner d below
/// the line q1 q2, and more than far_factor times the diameter of the overlap region of
/// two convex polygons. A negative depth of d counts as 0. The vertices of the region
/// are the ends of the segments of the sides of each polygon that lie in the other
/// polygon, borders included. Segments without length do not count. Returns false if
/// there are no vertices. The points `joints` are added to the vertices if there are
/// any.
[[gnu::cold, gnu::noinline]] bool is_far(const Vec2& c, const Vec2& p1, const Vec2& p2,
                                         const Vec2& d, const Vec2& q1, const Vec2& q2,
                                         Outline one, Outline other,
                                         std::span<const Vec2> joints);

/// Returns whether a side of a convex polygon has a segment of positive length in
/// another convex polygon, borders included.
[[gnu::cold, gnu::noinline]] bool has_segment(Outline polygon, int side, Outline other);

}  // namespace blocks::geometry::exact
