// Finds out whether a corner is in a notch: beyond an end of a side, where a neighbour
// or another part of the block rises (docs/contact-rule.md#notches).
#pragma once

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/closed_joints.hpp"
#include "dynamics/rules/overlap_region.hpp"
#include "dynamics/rules/pair_shape.hpp"
#include "dynamics/rules/part_box.hpp"
#include "geometry/notch.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// For `neighbours` see ClosedJoints.
template <class Predicates, class Neighbours> class Notches {
 public:
  Notches(const Blocks& blocks, const BlockParts& parts, const Neighbours& neighbours,
          const PairShape<Predicates>& shape, OverlapRegion<Predicates>& region,
          geometry::Polygon& copy)
      : blocks_(blocks), parts_(parts), neighbours_(neighbours), shape_(shape),
        region_(region), copy_(copy) {}

  /// Returns whether a corner, whose foot is not between the ends of the side, acts on
  /// it in a notch. The corner must be inside the side.
  bool has(const PairSide& corner, const PairSide& side) {
    const Segment& e = shape_.at(side);
    const Vec2& c = shape_.at(corner).start;
    return Predicates::notches && geometry::is_near_ends(c, e.start, e.end) &&
           region_.has_segment(side) && is_foot_inside(c, e, side.part);
  }

 private:
  /// Returns whether the raised foot is inside another part of the side's block, or
  /// inside a part that may cover sides of that block.
  bool is_foot_inside(const Vec2& c, const Segment& e, int of_side) {
    const int own = shape_.part(of_side), other = shape_.part(1 - of_side);
    const auto is_inside = [&](int part) {
      return geometry::is_raised_foot_inside(c, e.start, e.end,
                                             parts_.outline(blocks_, part, copy_));
    };
    const int block = parts_.block(own);
    for (int part = parts_.first_part(block); part < parts_.end_part(block); ++part)
      if (part != own && is_inside(part))
        return true;
    const PartBox of_other(blocks_, parts_, other);
    bool found = false;
    each_covering_part(blocks_, parts_, neighbours_, own, other, [&](int part) {
      found =
          found || (PartBox(blocks_, parts_, part).meets(of_other) && is_inside(part));
    });
    return found;
  }

  const Blocks& blocks_;
  const BlockParts& parts_;
  const Neighbours& neighbours_;
  const PairShape<Predicates>& shape_;
  OverlapRegion<Predicates>& region_;
  geometry::Polygon& copy_;
};

}  // namespace blocks::dynamics
