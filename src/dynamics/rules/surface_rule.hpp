// Decides which corners of two blocks act on which edges by one principle: a closed
// joint is not there (docs/surface-rule.md). Of the axes of two parts whose side is
// surface of the blocks as a whole, the one of least depth acts. `blocks study` runs it
// beside the contact rule.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/rules/pair_shape.hpp"
#include "dynamics/rules/part_box.hpp"
#include "geometry/contact_constants.hpp"
#include "geometry/continuation.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// The parts that may continue one of the two parts of a pair.
class ThirdParts {
 public:
  /// Collects the other parts of the block of `own`, and the parts of all blocks that
  /// the block of `other` is paired with, if their boxes meet the grown one of `other`.
  /// For `neighbours` see ClosedJoints.
  template <class Neighbours>
  void collect(const Blocks& blocks, const BlockParts& parts,
               const Neighbours& neighbours, int own, int other) {
    count_ = 0;
    const PartBox of_other = PartBox(blocks, parts, other).grown(geometry::third_reach);
    const auto add = [&](int part) {
      if (!PartBox(blocks, parts, part).meets(of_other))
        return;
      if (outlines_.size() == count_)
        outlines_.emplace_back();
      geometry::Polygon& outline = outlines_[count_++];
      outline.clear();
      for (int i = 0; i < parts.corners(part); ++i)
        outline.push_back(blocks.corner.col(parts.corner(part, i)));
    };
    const int own_block = parts.block(own), other_block = parts.block(other);
    neighbours(other_block, [&](int block) {
      if (block != own_block && block != other_block &&
          blocks.may_touch(block, other_block))
        for (int part = parts.first_part(block); part < parts.end_part(block); ++part)
          add(part);
    });
    for (int part = parts.first_part(own_block); part < parts.end_part(own_block);
         ++part)
      if (part != own)
        add(part);
  }
  /// Returns whether condition(outline) is true for one of the parts.
  template <class Condition> bool any(const Condition& condition) const {
    return std::any_of(outlines_.begin(),
                       outlines_.begin() + static_cast<std::ptrdiff_t>(count_),
                       condition);
  }

 private:
  std::vector<geometry::Polygon> outlines_;
  std::size_t count_ = 0;
};

/// The surface rule. For `neighbours` see ClosedJoints.
template <class Neighbours> class SurfaceRule {
 public:
  SurfaceRule(const Blocks& blocks, const BlockParts& parts,
              const Neighbours& neighbours, PairScratch& scratch)
      : blocks_(blocks), parts_(parts), neighbours_(neighbours), scratch_(scratch) {}

  /// Returns the contacts between two blocks, without duplicates. The result is valid
  /// until the next call.
  const std::vector<CornerOnEdge>& decide(int a, int b) {
    scratch_.found.clear();
    each_pair_of_parts(parts_, a, b, [&](int p, int q) { decide_parts(p, q); });
    return scratch_.found;
  }

 private:
  /// Lets the first axis in the order of depth act that is neither far nor hidden. The
  /// axis of least depth is never far. If none is left and no third part carries the
  /// block, it acts although it is hidden.
  void decide_parts(int p, int q) {
    shape_.take(blocks_, parts_, p, q);
    if (!shape_.find_axes(scratch_.axes))
      return;  // the two parts are apart
    take_outlines();
    Axis axis = least_ = shape_.take_least(scratch_.axes);
    if (shape_.depth_sign(least_.side, least_.corner.index) <= 0) {
      touch(least_, shape_.find_facing(least_));
      return;
    }
    for (;; axis = shape_.take_least(scratch_.axes)) {
      const std::optional<PairSide> facing = facing_of(axis);
      if (!is_beyond_inner(axis) && !is_far(axis, facing) && !is_hidden(axis, facing)) {
        touch(axis, facing);
        return;
      }
      if (scratch_.axes.empty()) {
        // Otherwise a third part carries the block.
        if (exceeds_third_shifts(least_.corner, least_.side))
          touch(least_, shape_.find_facing(least_));
        return;
      }
    }
  }

  void take_outlines() {
    for (const int k : {0, 1}) {
      outline_[k].clear();
      for (int i = 0; i < shape_.corners(k); ++i)
        outline_[k].push_back(shape_.at({k, i}).start);
      has_thirds_[k] = false;
    }
  }
  /// Returns the third parts of part k. They are collected when they are first needed.
  const ThirdParts& thirds(int k) {
    if (!has_thirds_[k])
      thirds_[k].collect(blocks_, parts_, neighbours_, shape_.part(k),
                         shape_.part(1 - k));
    has_thirds_[k] = true;
    return thirds_[k];
  }

  /// Returns the facing side of an axis. If the axis is not the least one, the side has
  /// to cross the other part.
  std::optional<PairSide> facing_of(const Axis& axis) {
    const std::optional<PairSide> facing = shape_.find_facing(axis);
    return facing && (axis == least_ || crosses(*facing)) ? facing : std::nullopt;
  }
  bool crosses(const PairSide& side) const {
    return geometry::crosses(outline_[side.part], side.index, outline_[1 - side.part]);
  }
  /// Returns whether the part beside an inner side decides, because the side does not
  /// cross the other part.
  bool is_beyond_inner(const Axis& axis) const {
    return shape_.at(axis.side).is_inner && !(axis == least_) && !crosses(axis.side);
  }

  /// Returns whether the axis is far: its corner, or both ends of its facing side.
  bool is_far(const Axis& axis, const std::optional<PairSide>& facing) {
    if (axis == least_)
      return false;
    if (!facing)
      return is_far(axis.corner, axis.side);
    return is_far(*facing, axis.side) && is_far(shape_.after(*facing), axis.side);
  }
  /// Returns whether a corner is far below a side.
  bool is_far(const PairSide& corner, const PairSide& side) {
    const geometry::filter::Estimate &depth = shape_.depth(side, corner.index),
                                     &least = shape_.depth(least_);
    if (depth.value + depth.bound <=
        geometry::deepest_share * (least.value - least.bound))
      return false;
    const Segment& e = shape_.at(side);
    const Vec2& c = shape_.at(corner).start;
    return geometry::exceeds_separating_shift(c, e.start, e.end, outline_[0],
                                              outline_[1]) &&
           geometry::exceeds_common_region(c, e.start, e.end, outline_[0],
                                           outline_[1]) &&
           exceeds_third_shifts(corner, side);
  }
  /// Returns whether the depth of a corner below a side exceeds twice every shift that
  /// separates one of the two parts from a third part.
  bool exceeds_third_shifts(const PairSide& corner, const PairSide& side) {
    const Segment& e = shape_.at(side);
    const Vec2& c = shape_.at(corner).start;
    const auto holds = [&](int k) {
      return thirds(k).any([&](const geometry::Polygon& third) {
        return !geometry::exceeds_separating_shift(c, e.start, e.end, outline_[1 - k],
                                                   third);
      });
    };
    return !holds(0) && !holds(1);
  }

  bool is_hidden(const Axis& axis, const std::optional<PairSide>& facing) {
    const geometry::PolygonAxis polygons = as_polygons(axis, facing);
    const int own = axis.side.part;
    const auto hides = [&](int k, geometry::Continues which) {
      return thirds(k).any([&](const geometry::Polygon& third) {
        return geometry::is_hidden_by(polygons, third, which);
      });
    };
    return hides(own, geometry::Continues::own) ||
           hides(1 - own, geometry::Continues::other);
  }
  geometry::PolygonAxis as_polygons(const Axis& axis,
                                    const std::optional<PairSide>& facing) const {
    return {outline_[axis.side.part], axis.side.index, outline_[axis.corner.part],
            axis.corner.index, facing ? facing->index : -1};
  }

  /// Adds the contacts that act along an axis.
  void touch(const Axis& axis, const std::optional<PairSide>& facing) {
    each_along(shape_, axis, facing, [&](const PairSide& corner, const PairSide& side) {
      const PairSide below = find_side_below(corner, side);
      if (!shape_.at(below).is_inner && shape_.depth_sign(below, corner.index) > 0 &&
          (is_between(corner, below) || (!facing && has_no_end(axis.corner, below))) &&
          (axis == least_ || !is_far(corner, below)))
        scratch_.add({shape_.at(corner).corner, shape_.at(below).corner});
    });
  }
  /// Returns the one of a side and the sides in line with it that has the foot of the
  /// corner between its ends. If there is none, returns the side itself.
  PairSide find_side_below(const PairSide& corner, const PairSide& side) {
    if (is_between(corner, side))
      return side;
    std::optional<PairSide> found;
    shape_.each_in_line(side, [&](const PairSide& one) {
      if (!found && is_between(corner, one))
        found = one;
    });
    return found.value_or(side);
  }
  bool is_between(const PairSide& corner, const PairSide& side) {
    const Segment& e = shape_.at(side);
    return predicates_.between(shape_.at(corner).start, e.start, e.end);
  }
  /// Returns whether a side has no end where the foot of the corner of its axis is
  /// beyond it: a third part rises there, or is beyond a gap.
  bool has_no_end(const PairSide& corner, const PairSide& side) {
    const geometry::PolygonAxis polygons = as_polygons({side, corner}, {}),
                                least = as_polygons(least_, {});
    const Segment& e = shape_.at(side);
    const Vec2& c = shape_.at(corner).start;
    return thirds(side.part).any([&](const geometry::Polygon& third) {
      return geometry::is_in_notch_of(polygons, third) ||
             geometry::is_over_gap_to(c, e.start, e.end, least, third);
    });
  }

  const Blocks& blocks_;
  const BlockParts& parts_;
  const Neighbours& neighbours_;
  PairScratch& scratch_;
  ExactPredicates predicates_;
  PairShape<ExactPredicates> shape_{scratch_.shape, predicates_};
  Axis least_;
  geometry::Polygon outline_[2];
  ThirdParts thirds_[2];
  bool has_thirds_[2] = {};
};

}  // namespace blocks::dynamics
