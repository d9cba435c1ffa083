#include "dynamics/rules/pair_rule.hpp"

#include <memory>
#include <optional>

#include "dynamics/rules/kept_depths.hpp"
#include "dynamics/rules/pair_shape.hpp"
#include "dynamics/rules/third_parts.hpp"
#include "geometry/contact_constants.hpp"
#include "geometry/contact_predicates.hpp"
#include "geometry/continuation.hpp"
#include "geometry/polygon.hpp"

namespace blocks::dynamics {
namespace {

class PairRule {
 public:
  PairRule(const Blocks& blocks, const BlockParts& parts, const Groups& neighbours,
           const RuleParts& rule_parts, PairScratch& scratch)
      : blocks_(blocks), parts_(parts), neighbours_(neighbours),
        rule_parts_(rule_parts), scratch_(scratch) {
    clear();
  }

  void decide(int a, int b) {
    each_pair_of_parts(parts_, a, b, [&](int p, int q) { decide_parts(p, q); });
  }

 private:
  void clear() {
    scratch_.found.clear();
    scratch_.candidates.clear();
    scratch_.depths.clear();
    scratch_.may_be_kept = true;
    scratch_.asked_of_third = false;
  }
  /// What the search for the acting axis of two parts finds.
  enum class Search { apart, axis, no_axis };

  /// Tests the contacts of the acting axis, unless a third part carries one of the two.
  void decide_parts(int p, int q) {
    const Search search = find_axis(p, q);
    if (search != Search::apart && !(is_doubtful(search) && is_carried()))
      touch(axis_, facing_);
  }
  /// Finds the first axis in the order of depth that is neither far nor hidden. The
  /// axis of least depth is never far. If no axis is left, it acts although it is
  /// hidden.
  Search find_axis(int p, int q) {
    shape_.take(blocks_, parts_, p, q);
    if (!shape_.find_axes(scratch_.axes)) {
      depths_.keep_apart(shape_.separating());
      return Search::apart;
    }
    take_outlines();
    axis_ = least_axis_ = shape_.take_least(scratch_.axes);
    depths_.keep_least(least_axis_, scratch_.axes);
    facing_ = shape_.find_facing(least_axis_);
    if (shape_.depth_sign(least_axis_.side, least_axis_.corner.index) <= 0)
      return Search::axis;
    for (;; axis_ = shape_.take_least(scratch_.axes)) {
      facing_ = facing_of(axis_);
      if (!shape_.at(axis_.side).is_inner && !is_far(axis_, facing_) &&
          !is_hidden(axis_, facing_))
        return Search::axis;
      if (scratch_.axes.empty())
        break;
    }
    axis_ = least_axis_;
    facing_ = shape_.find_facing(least_axis_);
    return Search::no_axis;
  }
  /// Returns whether a pair may be left to a third part: no axis is left, or the acting
  /// axis is not the least one, although the two parts overlap by no more than the
  /// slack: a corner may be beside a joint by rounding.
  bool is_doubtful(Search search) {
    if (search != Search::axis)
      return search == Search::no_axis;
    if (axis_ == least_axis_)
      return false;
    const Segment& e = shape_.at(least_axis_.side);
    return geometry::near_or_inside(shape_.at(least_axis_.corner).start, e.end,
                                    e.start);
  }
  /// Returns whether a third part carries one of the two: it hides the least axis,
  /// overlaps that part at least half as deep as the two overlap each other, has a
  /// contact with it, and forms a doubtful pair with neither of the two.
  bool is_carried() {
    const Segment& e = shape_.at(least_axis_.side);
    const Vec2& c = shape_.at(least_axis_.corner).start;
    const geometry::PolygonAxis polygons =
        as_polygons(least_axis_, shape_.find_facing(least_axis_));
    bool found = false;
    for (const int k : {0, 1}) {
      const auto which = k == least_axis_.side.part ? geometry::Continues::own
                                                    : geometry::Continues::other;
      thirds(k).each([&](int part, const geometry::Polygon& third) {
        found = found || (!geometry::exceeds_separating_shift(
                              c, e.start, e.end, scratch_.outline[1 - k], third) &&
                          geometry::is_hidden_by(polygons, third, which) &&
                          has_contact(part, shape_.part(1 - k)) &&
                          !is_doubtful(part, shape_.part(k)));
      });
    }
    return found;
  }
  bool has_contact(int p, int q) {
    return ask_of_pair(p, q, [](PairRule& rule, Search search) {
      if (search == Search::apart || rule.is_doubtful(search))
        return false;
      rule.touch(rule.axis_, rule.facing_);
      return !rule.scratch_.found.empty();
    });
  }
  bool is_doubtful(int p, int q) {
    return ask_of_pair(
        p, q, [](PairRule& rule, Search search) { return rule.is_doubtful(search); });
  }
  /// Applies the rule to two other parts up to the acting axis and asks a question.
  template <class Question> bool ask_of_pair(int p, int q, const Question& question) {
    if (!scratch_.of_third)
      scratch_.of_third = std::make_unique<PairScratch>();
    PairRule rule(blocks_, parts_, neighbours_, rule_parts_, *scratch_.of_third);
    const bool in_order = parts_.block(p) < parts_.block(q);
    const Search search = rule.find_axis(in_order ? p : q, in_order ? q : p);
    const bool answer = question(rule, search);
    scratch_.may_be_kept = scratch_.may_be_kept && scratch_.of_third->may_be_kept;
    scratch_.asked_of_third = true;
    return answer;
  }

  void take_outlines() {
    for (const int k : {0, 1}) {
      scratch_.outline[k].clear();
      for (int i = 0; i < shape_.corners(k); ++i)
        scratch_.outline[k].push_back(shape_.at({k, i}).start);
      has_thirds_[k] = false;
    }
  }
  /// Returns the third parts of part k. They are collected when they are first needed.
  const ThirdParts& thirds(int k) {
    if (!has_thirds_[k])
      scratch_.thirds[k].collect(blocks_, parts_, neighbours_, shape_.part(k),
                                 shape_.part(1 - k));
    has_thirds_[k] = true;
    return scratch_.thirds[k];
  }

  /// Returns the facing side of an axis. If the axis is not the least one, the side has
  /// to cross the other part.
  std::optional<PairSide> facing_of(const Axis& axis) {
    const std::optional<PairSide> facing = shape_.find_facing(axis);
    return facing && (axis == least_axis_ || crosses(*facing)) ? facing : std::nullopt;
  }
  bool crosses(const PairSide& side) const {
    return geometry::crosses(scratch_.outline[side.part], side.index,
                             scratch_.outline[1 - side.part]);
  }

  /// Returns whether the axis is far: its corner, or both ends of its facing side.
  bool is_far(const Axis& axis, const std::optional<PairSide>& facing) {
    if (axis == least_axis_)
      return false;
    if (!facing)
      return is_far(axis.corner, axis.side);
    return is_far(*facing, axis.side) && is_far(shape_.after(*facing), axis.side);
  }
  /// Returns whether a corner is far below a side.
  bool is_far(const PairSide& corner, const PairSide& side) {
    const geometry::filter::Estimate &depth = shape_.depth(side, corner.index),
                                     &least_depth = shape_.depth(least_axis_);
    if (!rule_parts_.far_axes ||
        depth.value + depth.bound <=
            geometry::deepest_share * (least_depth.value - least_depth.bound))
      return false;
    const Segment& e = shape_.at(side);
    const Vec2& c = shape_.at(corner).start;
    const geometry::Polygon(&outline)[2] = scratch_.outline;
    return geometry::exceeds_separating_shift(c, e.start, e.end, outline[0],
                                              outline[1]) &&
           geometry::exceeds_common_region(c, e.start, e.end, outline[0], outline[1]) &&
           exceeds_third_shifts(corner, side);
  }
  /// Returns whether the depth of a corner below a side exceeds twice every shift that
  /// separates one of the two parts from a third part.
  bool exceeds_third_shifts(const PairSide& corner, const PairSide& side) {
    const Segment& e = shape_.at(side);
    const Vec2& c = shape_.at(corner).start;
    const auto holds = [&](int k) {
      return thirds(k).any([&](const geometry::Polygon& third) {
        return !geometry::exceeds_separating_shift(c, e.start, e.end,
                                                   scratch_.outline[1 - k], third);
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
    return rule_parts_.third_parts && (hides(own, geometry::Continues::own) ||
                                       hides(1 - own, geometry::Continues::other));
  }
  geometry::PolygonAxis as_polygons(const Axis& axis,
                                    const std::optional<PairSide>& facing) const {
    return {scratch_.outline[axis.side.part], axis.side.index,
            scratch_.outline[axis.corner.part], axis.corner.index,
            facing ? facing->index : -1};
  }

  /// Adds the contacts that act along an axis.
  void touch(const Axis& axis, const std::optional<PairSide>& facing) {
    shape_.each_along(
        axis, rule_parts_.faces ? facing : std::nullopt,
        [&](const PairSide& corner, const PairSide& side) {
          const PairSide below = find_side_below(corner, side);
          if (shape_.at(below).is_inner ||
              (axis != least_axis_ && is_far(corner, below)))
            return;
          const CornerOnEdge contact{shape_.at(corner).corner, shape_.at(below).corner};
          PairScratch::add(scratch_.candidates, contact);
          if (!parts_.is_isolated(shape_.part(below.part), below.index))
            scratch_.may_be_kept = false;
          if (shape_.depth_sign(below, corner.index) <= 0)
            return;
          if (is_between(corner, below))
            return PairScratch::add(scratch_.found, contact);
          if (!facing && has_no_end(axis.corner, below)) {
            scratch_.may_be_kept = false;
            PairScratch::add(scratch_.found, contact);
          }
        });
  }
  /// Returns that one of a side and the edges in line with it that has the foot of the
  /// corner between its ends. If there is none, returns the side itself.
  PairSide find_side_below(const PairSide& corner, const PairSide& side) {
    if (is_between(corner, side))
      return side;
    std::optional<PairSide> found;
    shape_.each_in_line(side, [&](const PairSide& one) {
      if (!found && !shape_.at(one).is_inner && is_between(corner, one))
        found = one;
    });
    return found.value_or(side);
  }
  bool is_between(const PairSide& corner, const PairSide& side) {
    const Segment& e = shape_.at(side);
    return geometry::between(shape_.at(corner).start, e.start, e.end);
  }
  /// Returns whether a side has no end where the foot of the corner of its axis is
  /// beyond it: a third part rises there, or is beyond a joint.
  bool has_no_end(const PairSide& corner, const PairSide& side) {
    const geometry::PolygonAxis polygons = as_polygons({side, corner}, {}),
                                least_axis = as_polygons(least_axis_, {});
    const Segment& e = shape_.at(side);
    const Vec2& c = shape_.at(corner).start;
    return rule_parts_.third_parts &&
           thirds(side.part).any([&](const geometry::Polygon& third) {
             return geometry::is_in_notch_of(polygons, third) ||
                    geometry::is_at_joint_with(c, e.start, e.end, least_axis, third);
           });
  }

  const Blocks& blocks_;
  const BlockParts& parts_;
  const Groups& neighbours_;
  const RuleParts& rule_parts_;
  PairScratch& scratch_;
  PairShape shape_{scratch_.shape};
  KeptDepths depths_{shape_, parts_, scratch_.depths};
  Axis least_axis_, axis_;          ///< the least axis and the acting one
  std::optional<PairSide> facing_;  ///< the facing side of the acting axis
  bool has_thirds_[2] = {};
};

}  // namespace

void decide_pair(const Blocks& blocks, const BlockParts& parts,
                 const Groups& neighbours, int a, int b, const RuleParts& rule_parts,
                 PairScratch& scratch) {
  PairRule(blocks, parts, neighbours, rule_parts, scratch).decide(a, b);
}

}  // namespace blocks::dynamics
