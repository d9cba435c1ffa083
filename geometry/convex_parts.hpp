// A block outline cut into convex parts, which the contact rule decides one by one.
#pragma once

#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// The corners of each convex part of a simple outline, by index. Parts are clockwise,
/// also those of an anticlockwise outline. Cuts are diagonals between corners, so
/// nothing is constructed and nothing is rounded. A convex outline is one part with its
/// corners in order; an outline with a fault has no parts. Laws:
/// - The interiors of the parts are disjoint, and the parts fill the outline. Each part
///   has area, because it is made of triangles of a triangulation of the corners. It
///   may have straight corners.
/// - Each edge of the outline is a side of one part. Each other side belongs to two
///   parts, in opposite senses: no corner lies within a side of a triangle, so that a
///   diagonal is never divided on one of its two sides only.
std::vector<std::vector<int>> convex_parts(const Polygon& outline);

}  // namespace blocks::geometry
