// Whether neighbouring blocks cover a side of a block where another block has entered
// it: the question of closed joints in the contact rule
// (docs/contact-rule.md#covered-sides). Answered exactly for the stored doubles.
// Independent of the time loop.
#pragma once

#include <span>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// The corners of a convex polygon, clockwise, [L].
using Outline = std::span<const Vec2>;

/// A side of a convex polygon, and which of its two ends is asked about. Side i runs
/// from corner i to corner i + 1.
struct SideEnd {
  Outline polygon;
  int side = 0;
  bool at_start = true;
};

/// A neighbour and the side of it that covers most, both by index. -1: none covers.
struct Cover {
  int neighbour = -1;
  int side = -1;
  explicit operator bool() const { return neighbour >= 0; }
};

/// Whether the neighbours cover the side where `other` is. The part of the side that
/// lies in `other` is its interval; the stretch runs from the end of the side that is
/// asked about to the far end of the interval, and h is its length. A side of a
/// neighbour covers the common part of the two sides, at right angles to the first one,
/// if
/// - the two sides run against each other within ten degrees (edges_face),
/// - no other side of the two polygons is less deep than both (compare_depths): the two
///   touch, or are apart, along these sides,
/// - the gap between the two sides in the middle of what is covered of the stretch is
/// at
///   most h,
/// - `other` reaches at least h below the covering side, and holds a part of that side.
/// The neighbours cover the side if they cover half of the stretch and half of the
/// interval. The answer is the neighbour that covers the longest part of the stretch;
/// of equals, the first.
Cover covering(const SideEnd& end, Outline other, std::span<const Outline> neighbours);

/// True only if the neighbours certainly do not cover the side, and do not as long as
/// no difference of two corners changes by more than `room`, [L] >= 0. In plain doubles
/// with room for their rounding; false says nothing.
bool is_surely_uncovered(const SideEnd& end, Outline other,
                         std::span<const Outline> neighbours, double room);

namespace exact {

/// How often the calling thread took rationals because intervals could not answer.
unsigned long long covering_calls();

}  // namespace exact

}  // namespace blocks::geometry
