// PRIVATE to geometry/: where a line meets an outline, in order along the line. Part of
// split.cpp.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/exact/binary_unit.hpp"
#include "geometry/split.hpp"

namespace blocks::geometry::exact {

/// A point where the line meets the outline: a corner, or a crossing between the two
/// corners of a side.
struct LineMeet {
  int corner = -1;    ///< of the outline; -1: a crossing
  int side = -1;      ///< of the outline; -1: a corner
  Fraction part;      ///< of the side, from its first corner to the crossing
  Fraction along;     ///< from line.point in the direction of the line, in some unit
  bool left = true;   ///< a line infinitesimally left of this one crosses the outline
  bool right = true;  ///< likewise on the right
};

/// Returns all of them, ascending along the line. The outline and the line must be
/// finite.
std::vector<LineMeet> meets_of_line(const Polygon& outline, const SplitLine& line);

/// Returns the two ends of the chord that contains line.point or is nearest to it, of
/// two equally near ones the first. Returns nothing if the line has no point inside the
/// outline.
std::optional<std::pair<LineMeet, LineMeet>>
nearest_chord(const std::vector<LineMeet>& meets);

}  // namespace blocks::geometry::exact
