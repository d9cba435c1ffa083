// What the rounding of corners alone can do to neighbours that are meant to touch: to
// doubles, and before that to the decimals of a deck.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/block_shape.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {

/// Units in the last place of the largest coordinate by which they may overlap or part.
inline constexpr double rounding_units = 4.0;

/// And by this part of the smaller block's size, the root of its area: twelve digits.
inline constexpr double rounding_part = 1e-11;

/// The largest overlap of two blocks that is rounding, along the whole outline of the
/// one whose outline is shorter, [L^2].
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
