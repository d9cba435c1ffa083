// The corners of a convex polygon, as a view.
#pragma once

#include <span>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// The corners of a convex polygon, clockwise, [L].
using Outline = std::span<const Vec2>;

}  // namespace blocks::geometry
