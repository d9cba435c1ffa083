// Whether one part has come into the other one through the side of an axis
// (docs/contact-rule.md#entry).
#pragma once

#include <optional>

#include "dynamics/rules/pair_shape.hpp"

namespace blocks::dynamics {

template <class Predicates> class Entry {
 public:
  Entry(PairShape<Predicates>& shape, Predicates& ask) : shape_(shape), ask_(ask) {}

  /// Needs the depths below all sides of both parts.
  bool is_entered(const Axis& axis) {
    PairSide out;
    const int outside = shape_.sides_outside(axis.corner, axis.side.index, out);
    return outside == 0 ||
           (Predicates::crossing && shape_.find_facing(axis) &&
            (is_beyond(axis) || (outside == 1 && sides_cross(axis, out))));
  }
  /// The corner is beyond an end of the axis side, or within the slack of one.
  bool is_beyond(const Axis& axis) {
    const Segment& e = shape_.at(axis.side);
    return !ask_.well_between(shape_.at(axis.corner).start, e.start, e.end);
  }
  /// The corner has passed only the side `out`. It is next to the axis side, and the
  /// end that the two share has left the corner's part.
  bool sides_cross(const Axis& axis, const PairSide& out) {
    const auto has_left = [&](const PairSide& end) {
      PairSide other;
      return shape_.sides_outside(end, -1, other) > 0;
    };
    const PairSide next = shape_.after(axis.side);
    return (out == shape_.before(axis.side) && has_left(axis.side)) ||
           (out == next && has_left(next));
  }

 private:
  PairShape<Predicates>& shape_;
  Predicates& ask_;
};

}  // namespace blocks::dynamics
