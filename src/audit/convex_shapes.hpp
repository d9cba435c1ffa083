// Convex polygons in whole numbers: how deep they overlap, what they have in common,
// and how one leaves another.
#pragma once

#include <optional>
#include <vector>

#include "audit/whole_numbers.hpp"

namespace blocks::audit {

/// The corners of a convex polygon, clockwise, in units of a lattice.
using Shape = std::vector<Point>;

/// A side from its start. Points to the right of it are below it.
struct Line {
  Point start, along;
  Whole length2() const { return dot(along, along); }
  Length length() const { return {length2(), length2()}; }
  /// Returns twice the area below the line: the depth of the point times the length.
  Whole area2(const Point& point) const { return cross(point - start, along); }
  Length depth(const Point& point) const { return {area2(point), length2()}; }
};

Line side_of(const Shape& shape, int index);

/// Returns the shape in a lattice that is finer by a factor, shifted there.
Shape refined(const Shape& shape, const Whole& factor, const Point& shift);

/// Returns the depth of the deepest corner of the shape below a line.
Length deepest(const Line& line, const Shape& shape);

/// Returns the depth of the least axis of two shapes: the shortest shift that separates
/// them. It is not positive if they are separate.
Length separating_shift(const Shape& one, const Shape& other);

/// Returns the length of the longest side.
Length longest_side(const Shape& shape);

/// Returns where a line enters and leaves a shape, in units of its vector from its
/// start. It is empty if the line misses the shape. Both positions may be equal.
struct Chord {
  Ratio begin, end;
};
std::optional<Chord> chord(const Line& line, const Shape& shape);

/// Returns whether a segment of the side, of positive length, lies in the shape,
/// borders included.
bool crosses(const Line& side, const Shape& shape);

/// Returns the diameter of the region that two shapes have in common; 0 if there is
/// none.
Length common_diameter(const Shape& one, const Shape& other);

/// Returns how far a shape moves until it leaves another one that it overlaps, in units
/// of the vector `way`.
Ratio way_out(const Shape& moving, const Point& way, const Shape& resting);

}  // namespace blocks::audit
