// Whether neighbouring blocks cover a side of a block where another block has entered
// it: the question of closed joints in the contact rule
// (docs/contact-rule.md#covered-sides). Answered exactly for the stored doubles.
// Independent of the time loop.
#pragma once

#include <span>

#include "geometry/contact_constants.hpp"
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
///   at most h,
/// - `other` reaches at least h below the covering side,
/// - `other` holds a part of the covering side, or the two sides overlap there, by at
///   most h.
/// The neighbours cover the side if they cover half of the stretch and half of the
/// interval. The answer is the neighbour that covers the longest part of the stretch;
/// of equals, the first.
Cover covering(const SideEnd& end, Outline other, std::span<const Outline> neighbours);

/// The quick half of the question, in plain doubles with room for rounding and for
/// motion: whether neighbours certainly do not cover the side. It needs no memory. The
/// share of the stretch is bounded. That two sides touch is tested only where they
/// overlap, and the share of the interval is not tested.
class UncoveredSide {
 public:
  /// [L] No difference of two corners of the polygon and `other` changes by more than
  /// `room`, none of corners of a neighbour, or of one and a corner of these two, by
  /// more than `of_neighbours` >= room >= 0.
  UncoveredSide(const SideEnd& end, Outline other, double room, double of_neighbours);
  /// Adds a neighbour.
  void add(Outline neighbour);
  /// Whether the neighbours so far certainly do not cover the side, now and after any
  /// motion that the room allows. False says nothing.
  bool is_sure() const { return share_ < covered_share; }

 private:
  /// Both ends of a neighbour's side are outside the same side of `other`.
  bool is_outside(const Vec2& start, const Vec2& end) const;
  /// A neighbour is outside a side of the own polygon, other than the side itself, or
  /// inside it by less than `depth`.
  bool is_less_deep(Outline neighbour, double depth) const;
  /// The numbers are too large or too small for doubles.
  void give_up() { share_ = 1.0; }

  SideEnd end_;
  Outline other_;
  Vec2 first_, along_;                    ///< the side: its start, a unit vector
  double length_, room_, of_neighbours_;  ///< [L]
  double turn_;  ///< by how much the side may turn against a neighbour
  bool at_start_;
  double least_, most_;  ///< [L] bounds of h
  bool is_empty_;        ///< No part of the side lies in `other`.
  double share_ = 0.0;  ///< An upper bound of the share of the stretch that is covered.
};

namespace exact {

/// How often the calling thread took rationals because intervals could not answer.
unsigned long long covering_calls();

}  // namespace exact

}  // namespace blocks::geometry
