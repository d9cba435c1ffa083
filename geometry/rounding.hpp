// Bounds of the overlap or gap that rounding alone can cause between blocks that are
// meant to touch. Corners are rounded twice: to the decimals of a deck, then to
// doubles.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/block_shape.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {

/// Overlaps and gaps up to this many units in the last place of the largest coordinate
/// are attributed to rounding to doubles.
inline constexpr double rounding_units = 4.0;

/// Overlaps up to this multiple of the smaller block's size, the square root of its
/// area, are attributed to decimals of twelve digits.
inline constexpr double rounding_part = 1e-11;

/// Returns the largest overlap area of two blocks that is attributed to rounding,
/// [L^2]. It is the shorter of the two perimeters times the width allowed for rounding.
inline double rounding_area(const Polygon& p, const Polygon& q) {
  const auto outline_length = [](const Polygon& outline) {
    double length = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i)
      length += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    return length;
  };
  const auto area = [](const Polygon& outline) {
    return std::abs(section_properties(outline).area);
  };
  return std::min(outline_length(p), outline_length(q)) *
         (rounding_units * std::max(coarsest_ulp(p), coarsest_ulp(q)) +
          rounding_part * std::sqrt(std::min(area(p), area(q))));
}

}  // namespace blocks::geometry
