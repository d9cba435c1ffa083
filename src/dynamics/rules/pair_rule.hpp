// Decides which corners of two blocks act on which edges: the contact rule
// (docs/contact-rule.md). The result depends only on the two blocks and on the blocks
// whose bounding boxes meet that of one of the two. All predicates are exact. The rule
// is independent of the contact list and of the time loop. It is a template over the
// predicates, so that `blocks study` can replace them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/closed_joints.hpp"
#include "dynamics/rules/entry.hpp"
#include "dynamics/rules/notches.hpp"
#include "dynamics/rules/overlap_region.hpp"
#include "dynamics/rules/pair_shape.hpp"
#include "dynamics/rules/predicates.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// A corner that acts on an edge of another block. The edge is named by its first
/// corner.
struct CornerOnEdge {
  int corner = -1, edge = -1;
  bool operator==(const CornerOnEdge&) const = default;
};

/// Working memory of the rule for one thread. It grows as needed and is reused.
struct PairScratch {
  PairMemory shape;
  JointScratch joints;
  OverlapMemory region;
  geometry::Polygon polygon;  ///< of Notches
  std::vector<Axis> axes;
  std::vector<CornerOnEdge> found;

  /// Adds a contact unless it is there already.
  void add(const CornerOnEdge& contact) {
    if (std::find(found.begin(), found.end(), contact) == found.end())
      found.push_back(contact);
  }
};

/// Calls visit(p, q) for each part p of the block with the lower number and each part q
/// of the other block. So of equally deep axes, one of the lower block comes first.
template <class Visit>
void each_pair_of_parts(const BlockParts& parts, int a, int b, const Visit& visit) {
  const auto [low, high] = std::minmax(a, b);
  for (int p = parts.first_part(low); p < parts.end_part(low); ++p)
    for (int q = parts.first_part(high); q < parts.end_part(high); ++q)
      visit(p, q);
}

/// Calls visit(corner, side) for each contact that may act along an axis. With a facing
/// side, these are the ends of each face on the other face; otherwise it is the corner
/// of the axis. A face may consist of several sides in line. The ends of inner sides in
/// line with the axis side are left out.
template <class Predicates, class Visit>
void each_along(PairShape<Predicates>& shape, const Axis& axis,
                const std::optional<PairSide>& facing, const Visit& visit) {
  const PairSide& e = axis.side;
  if (!facing)
    return visit(axis.corner, e);
  shape.each_in_line(*facing, [&](const PairSide& side) {
    visit(side, e);
    visit(shape.after(side), e);
  });
  shape.each_in_line(e, [&](const PairSide& side) {
    if (shape.at(side).is_inner)
      return;
    visit(side, *facing);
    visit(shape.after(side), *facing);
  });
}

/// The contact rule. For `neighbours` see ClosedJoints.
template <class Predicates, class Neighbours> class PairRule {
 public:
  PairRule(const Blocks& blocks, const BlockParts& parts, const Neighbours& neighbours,
           PairScratch& scratch)
      : blocks_(blocks), parts_(parts), scratch_(scratch),
        joints_(blocks, parts, neighbours, shape_, predicates_, scratch.joints),
        notches_(blocks, parts, neighbours, shape_, region_, scratch.polygon) {}

  /// Returns the contacts between two blocks, without duplicates. The result is valid
  /// until the next call.
  const std::vector<CornerOnEdge>& decide(int a, int b) {
    scratch_.found.clear();
    each_pair_of_parts(parts_, a, b, [&](int p, int q) { decide_parts(p, q); });
    return scratch_.found;
  }

 private:
  /// Makes the choice of docs/contact-rule.md#choice. If the first entered axis is not
  /// hidden, its contacts act. If it is hidden, the surface of a closed joint takes
  /// over, at most twice. If no axis is entered, or no contact acts along the first
  /// entered axis and its side is an edge, the least axis is used instead. If the
  /// second surface is hidden too, the first entered axis is used. If no contact acts
  /// along a surface that took over, none acts.
  void decide_parts(int p, int q) {
    shape_.take(blocks_, parts_, p, q);
    if (!shape_.find_axes(scratch_.axes))
      return;  // the two parts are apart
    const Axis least = shape_.take_least(scratch_.axes);
    region_.begin(least);
    if (shape_.depth_sign(least.side, least.corner.index) <= 0) {
      touch(least, shape_.find_facing(least));
      return;
    }
    const std::optional<Axis> entered = find_entered(least);
    if (!entered) {
      stand_in(least);
      return;
    }
    Axis axis = *entered;
    for (int looks = 0; looks < 3; ++looks) {
      const std::optional<PairSide> facing = shape_.find_facing(axis);
      const std::optional<Surface> surface = surface_instead_of(axis, facing);
      if (!surface || surface->axis.side == entered->side) {
        // If the side is an inner side, the part beside it decides.
        const bool acts = touch(axis, facing);
        if (!acts && looks == 0 && !shape_.at(axis.side).is_inner)
          stand_in(least);
        return;
      }
      axis = surface->axis;
      region_.extend(surface->joint);
    }
    region_.begin(least);
    stand_in(*entered);
  }

  /// Returns the first entered axis in the order of depth. Far axes are not entered.
  std::optional<Axis> find_entered(const Axis& least) {
    Entry<Predicates> entry(shape_, predicates_);
    for (Axis axis = least;; axis = shape_.take_least(scratch_.axes)) {
      // Entry is tested first, because it takes less time.
      if ((!Predicates::entry || entry.is_entered(axis)) &&
          !region_.is_far(axis, shape_.find_facing(axis)))
        return axis;
      if (scratch_.axes.empty())
        return std::nullopt;
    }
  }
  /// The axis of a surface that takes over, and the corner of its joint.
  struct Surface {
    Axis axis;
    PairSide joint;
  };

  /// Returns the least axis of the surfaces of all closed joints that hide the axis. If
  /// several are equally deep, it is the surface of the joint that is visited first.
  /// Returns nothing if the axis is not hidden.
  std::optional<Surface> surface_instead_of(const Axis& axis,
                                            const std::optional<PairSide>& facing) {
    std::optional<Surface> found;
    if (Predicates::covered_sides)
      joints_.any_hiding(axis, facing, [&](const Joint& joint) {
        const Axis one = shape_.axis_of(joint.surface);
        if (!found || shape_.is_less(one, found->axis))
          found = {one, joint.corner()};
        return false;  // continue with the next joint
      });
    return found;
  }

  /// Adds the contacts that act along an axis and returns whether there are any. The
  /// axis is not hidden, so its corners are not hidden either.
  bool touch(const Axis& axis, const std::optional<PairSide>& facing) {
    bool acts = false;
    each_along(shape_, axis, Predicates::faces ? facing : std::nullopt,
               [&](const PairSide& corner, const PairSide& side) {
                 acts = try_contact(corner, side, !facing) || acts;
               });
    return acts;
  }
  /// Adds the corner of the axis as a contact on the axis side, if the corner is inside
  /// it and between its ends or in a notch.
  void stand_in(const Axis& axis) {
    try_contact(axis.corner, axis.side, !shape_.find_facing(axis));
  }
  /// Adds a contact if its corner is inside the side or one in line with it, is not
  /// far and has its foot between the ends. If `may_be_in_notch`, a foot in a
  /// notch is sufficient. Returns whether the contact acts.
  bool try_contact(const PairSide& corner, const PairSide& side, bool may_be_in_notch) {
    const std::optional<PairSide> found =
        find_side_below(corner, side, may_be_in_notch);
    if (!found || region_.is_far(*found, corner.index))
      return false;
    add(corner, *found);
    return true;
  }
  /// Returns the one of a side and the sides in line with it that has the corner inside
  /// and its foot between the ends. If no side has the foot between its ends, it is the
  /// first one that has the corner in a notch at its end.
  std::optional<PairSide> find_side_below(const PairSide& corner, const PairSide& side,
                                          bool may_be_in_notch) {
    if (is_between(corner, side))
      return has_inside(corner, side) ? std::optional(side) : std::nullopt;
    std::optional<PairSide> below, in_notch;
    shape_.each_in_line(side, [&](const PairSide& one) {
      if (!below && is_between(corner, one))
        below = one;
    });
    if (below)
      return has_inside(corner, *below) ? below : std::nullopt;
    if (may_be_in_notch)
      shape_.each_in_line(side, [&](const PairSide& one) {
        if (!in_notch && has_inside(corner, one) && notches_.has(corner, one))
          in_notch = one;
      });
    return in_notch;
  }
  /// Returns whether a side is an edge that has the corner inside.
  bool has_inside(const PairSide& corner, const PairSide& side) {
    return !shape_.at(side).is_inner && shape_.depth_sign(side, corner.index) > 0;
  }
  bool is_between(const PairSide& corner, const PairSide& side) {
    const Segment& e = shape_.at(side);
    return predicates_.between(shape_.at(corner).start, e.start, e.end);
  }
  void add(const PairSide& corner, const PairSide& side) {
    scratch_.add({shape_.at(corner).corner, shape_.at(side).corner});
  }

  const Blocks& blocks_;
  const BlockParts& parts_;
  PairScratch& scratch_;
  Predicates predicates_;
  PairShape<Predicates> shape_{scratch_.shape, predicates_};
  OverlapRegion<Predicates> region_{shape_, scratch_.region};
  ClosedJoints<Predicates, Neighbours> joints_;
  Notches<Predicates, Neighbours> notches_;
};

}  // namespace blocks::dynamics
