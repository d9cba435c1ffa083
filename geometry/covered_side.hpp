// Decides whether neighbouring blocks cover a side of a block where another block has
// entered it (docs/contact-rule.md#covered-sides). The contact rule uses this for
// closed joints. The answer is exact for the stored doubles. Independent of the time
// loop.
#pragma once

#include <span>

#include "geometry/contact_constants.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// The corners of a convex polygon, clockwise, [L].
using Outline = std::span<const Vec2>;

/// A side of a convex polygon, and the one of its two ends that is tested. Side i runs
/// from corner i to corner i + 1.
struct SideEnd {
  Outline polygon;
  int side = 0;
  bool at_start = true;
};

/// The side of a neighbour that covers most, both by index; -1 if none covers.
struct Cover {
  int neighbour = -1;
  int side = -1;
  explicit operator bool() const { return neighbour >= 0; }
};

/// Finds out whether the neighbours cover the side where `other` is. The part of the
/// side that lies in `other` is its interval. The stretch runs from the tested end of
/// the side to the far end of the interval; h is its length. A side of a neighbour
/// covers the common part of the two sides, projected at right angles to the tested
/// side, if
/// - the two sides are antiparallel within ten degrees (edges_face),
/// - no other axis of the two polygons is less deep (compare_depths), that is, the two
///   polygons touch or are separated along these sides,
/// - the gap between the two sides, in the middle of the covered part of the stretch,
///   is at most h,
/// - `other` reaches at least h below the covering side,
/// - `other` contains a part of the covering side, or the two sides overlap there by at
///   most h.
/// The neighbours cover the side if they cover half of the stretch and half of the
/// interval; what two of them cover counts twice. The result is the neighbour side that
/// covers the longest part of the stretch, or the first of several equal ones.
Cover find_cover(const SideEnd& end, Outline other,
                 std::span<const Outline> neighbours);

/// A quick test in plain doubles, with margins for rounding and motion: do the
/// neighbours certainly not cover the side? It allocates no memory. It bounds the
/// covered share of the stretch from above. Only where two sides overlap does it test
/// whether the polygons touch along them. It does not test the share of the interval.
class UncoveredSide {
 public:
  /// The two distances bound the motion, [L]. No difference between two corners of the
  /// polygon and `other` changes by more than `room`. No difference that involves a
  /// corner of a neighbour changes by more than `of_neighbours` >= room >= 0.
  UncoveredSide(const SideEnd& end, Outline other, double room, double of_neighbours);
  /// Adds a neighbour.
  void add(Outline neighbour);
  /// Tells whether the neighbours added so far certainly do not cover the side, now and
  /// after any motion within these bounds. False means undecided.
  bool is_sure() const { return share_ < covered_share; }

 private:
  /// Tells whether both ends of a neighbour's side are outside the same side of
  /// `other`.
  bool is_outside(const Vec2& start, const Vec2& end) const;
  /// Tells whether a neighbour is outside some side of the own polygon, other than the
  /// tested side, or inside it by less than `depth`.
  bool is_less_deep(Outline neighbour, double depth) const;
  /// Leaves the side undecided, because the numbers are too large or too small for
  /// doubles.
  void give_up() { share_ = 1.0; }

  SideEnd end_;
  Outline other_;
  Vec2 first_, along_;                    ///< start and unit vector of the side
  double length_, room_, of_neighbours_;  ///< [L]
  double turn_;  ///< bound of the rotation of the side against a neighbour
  bool at_start_;
  double least_, most_;  ///< [L] bounds of h
  bool is_empty_;        ///< no part of the side lies in `other`
  double share_ = 0.0;   ///< upper bound of the covered share of the stretch
};

namespace exact {

/// Returns how often the calling thread used rationals because intervals could not
/// decide.
unsigned long long covering_calls();

}  // namespace exact

}  // namespace blocks::geometry
