// Decides whether a corner is in a notch at the end of a side
// (docs/contact-rule.md#notches). The answers are exact for the stored doubles.
#pragma once

#include "geometry/contact_constants.hpp"
#include "geometry/covered_side.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Returns whether the foot of corner c is between the ends of the side p1 p2 or beyond
/// one of them by at most d / notch_slope, where d is the depth of the corner.
/// Unchanged when all coordinates are shifted or scaled exactly.
bool is_near_ends(const Vec2& c, const Vec2& p1, const Vec2& p2);

/// Returns whether the raised foot of corner c is strictly inside a convex polygon. The
/// foot, on the line p1 p2, is raised outwards at right angles to the line, by
/// notch_slope times its distance beyond the nearer end. The foot must not be between
/// the ends.
bool is_raised_foot_inside(const Vec2& c, const Vec2& p1, const Vec2& p2,
                           Outline polygon);

}  // namespace blocks::geometry
