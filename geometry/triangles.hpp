// Cuts a block outline into triangles, for programs that know no other polygons.
#pragma once

#include <array>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Returns the corners of each triangle of a simple outline, by index, clockwise. The
/// triangles fill the outline, their interiors are disjoint, and each has a positive
/// area (exactly). Every corner of the outline is a corner of a triangle, and no point
/// is constructed. An outline with a fault has no triangles.
std::vector<std::array<int, 3>> triangles(const Polygon& outline);

}  // namespace blocks::geometry
