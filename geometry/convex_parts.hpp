// Cuts a block outline into convex parts, for the contact rule
// (docs/contact-rule.md#parts).
#pragma once

#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Returns the corners of each convex part of a simple outline, by index. Parts are
/// clockwise, even if the outline is anticlockwise. Cuts are diagonals between corners,
/// so no point is constructed and no coordinate is rounded. A convex outline is one
/// part with its corners in order; an outline with a fault has no parts. Guarantees:
/// - The interiors of the parts are disjoint, and the parts fill the outline. Each part
///   has a positive area, because it consists of triangles of a triangulation of the
///   corners. It may have straight corners.
/// - Each edge of the outline is a side of exactly one part. Each other side belongs to
///   two parts, in opposite directions: no corner lies inside a side of a triangle, so
///   a diagonal is never divided on only one of its two sides.
std::vector<std::vector<int>> convex_parts(const Polygon& outline);

}  // namespace blocks::geometry
