// Decides whether one part has entered the other one through the side of an axis
// (docs/contact-rule.md#entry).
#pragma once

#include <optional>

#include "dynamics/rules/pair_shape.hpp"

namespace blocks::dynamics {

template <class Predicates> class Entry {
 public:
  Entry(PairShape<Predicates>& shape, Predicates& ask)
      : shape_(shape), predicates_(ask) {}

  /// Returns whether an axis, whose depth is positive, is entered. The depths below all
  /// sides of both parts must have been found.
  bool is_entered(const Axis& axis) {
    PairSide out;
    const int outside = shape_.sides_outside(axis.corner, axis.side.index, out);
    if (outside == 0)
      return true;
    const std::optional<PairSide> facing = shape_.find_facing(axis);
    return facing && (is_inside(axis.side.part, other_end(*facing, axis.corner)) ||
                      (Predicates::crossing &&
                       (is_beyond(axis) || (outside == 1 && sides_cross(axis, out)))));
  }
  /// Returns whether a corner, of the other part, is inside this part.
  bool is_inside(int part, const PairSide& corner) {
    for (int i = 0; i < shape_.corners(part); ++i)
      if (shape_.depth_sign({part, i}, corner.index) <= 0)
        return false;
    return true;
  }
  /// Returns whether the foot of the corner is beyond an end of the axis side, or
  /// within the slack of an end.
  bool is_beyond(const Axis& axis) {
    const Segment& e = shape_.at(axis.side);
    return !predicates_.well_between(shape_.at(axis.corner).start, e.start, e.end);
  }
  /// Returns whether sides cross. `out` is the only side that has the corner of the
  /// axis outside. It must be an edge next to the axis side, and the end that the two
  /// share must be outside the corner's part.
  bool sides_cross(const Axis& axis, const PairSide& out) {
    const PairSide next = shape_.after(axis.side);
    return !shape_.at(out).is_inner &&
           ((out == shape_.before(axis.side) && shape_.has_left(axis.side)) ||
            (out == next && shape_.has_left(next)));
  }

 private:
  PairSide other_end(const PairSide& side, const PairSide& end) const {
    return end == side ? shape_.after(side) : side;
  }

  PairShape<Predicates>& shape_;
  Predicates& predicates_;
};

}  // namespace blocks::dynamics
