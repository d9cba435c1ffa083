// Finds the closed joints that hide an axis (docs/contact-rule.md#closed-joints,
// #covered-sides and #hidden-axes).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/pair_shape.hpp"
#include "dynamics/rules/part_box.hpp"
#include "geometry/covered_side.hpp"
#include "geometry/polygon.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// A corner of a part with the two sides that meet there: the side of the joint, which
/// neighbours may cover, and its surface.
struct Joint {
  PairSide side, surface;
  /// True if the surface ends in the corner and the side starts there, false if it is
  /// the other way round.
  bool surface_is_before;

  /// Returns the side that starts in the corner of the joint.
  PairSide corner() const { return surface_is_before ? side : surface; }
};

/// Working memory of ClosedJoints.
struct JointScratch {
  std::vector<int> parts;
  std::vector<geometry::Polygon> polygons;
  geometry::Polygon own, other, neighbour;  ///< for parts of blocks that are not convex
  std::vector<geometry::Outline> outlines;
};

/// Calls visit(part) for each part that may cover a side of part `own` where part
/// `other` is. These are the parts of all blocks with which the block of `other` is
/// paired, if the two may touch. For `neighbours` see ClosedJoints.
template <class Neighbours, class Visit>
void each_covering_part(const Blocks& blocks, const BlockParts& parts,
                        const Neighbours& neighbours, int own, int other,
                        const Visit& visit) {
  const int own_block = parts.block(own), other_block = parts.block(other);
  neighbours(other_block, [&](int block) {
    if (block != own_block && block != other_block &&
        blocks.may_touch(block, other_block))
      for (int part = parts.first_part(block); part < parts.end_part(block); ++part)
        visit(part);
  });
}

/// A joint, given by the side of a part and one of its ends, and the other part.
struct SideOfJoint {
  int part, side;
  bool at_start;
  int other;
};

/// Returns whether neighbours certainly do not cover the side of a joint, now and after
/// any motion within the given rooms (geometry::UncoveredSide). room: of the two
/// blocks, [L]; of_neighbours: of their neighbours, [L].
template <class Neighbours>
bool is_surely_uncovered(const Blocks& blocks, const BlockParts& parts,
                         const Neighbours& neighbours, const SideOfJoint& of,
                         double room, double of_neighbours, JointScratch& scratch) {
  geometry::UncoveredSide side(
      {parts.outline(blocks, of.part, scratch.own), of.side, of.at_start},
      parts.outline(blocks, of.other, scratch.other), room, of_neighbours);
  each_covering_part(blocks, parts, neighbours, of.part, of.other, [&](int part) {
    if (side.is_sure())
      side.add(parts.outline(blocks, part, scratch.neighbour));
  });
  return side.is_sure();
}

/// Decides which joints are closed. neighbours(b, visit) has to call visit(block) for
/// each block that block b is paired with, in a fixed order.
template <class Predicates, class Neighbours> class ClosedJoints {
 public:
  ClosedJoints(const Blocks& blocks, const BlockParts& parts,
               const Neighbours& neighbours, PairShape<Predicates>& shape,
               Predicates& ask, JointScratch& scratch)
      : blocks_(blocks), parts_(parts), neighbours_(neighbours), shape_(shape),
        predicates_(ask), scratch_(scratch) {}

  /// Calls visit(joint) for each joint that hides the axis until a call returns true,
  /// and returns whether one did. Joints at the corner of the axis are tested only if
  /// the axis has no facing side. With a facing side, they are joints at its ends, or
  /// their surface faces the axis side.
  template <class Visit>
  bool any_hiding(const Axis& axis, const std::optional<PairSide>& facing,
                  const Visit& visit) {
    const auto at_ends = [&](const PairSide& g) {
      for (const Joint& joint :
           {Joint{g, shape_.before(g), true}, Joint{g, shape_.after(g), false}})
        if (find_closed(joint).closed && visit(joint))
          return true;
      return false;
    };
    if (at_ends(axis.side))
      return true;
    if (facing)
      return at_ends(*facing);
    const PairSide after = axis.corner, before = shape_.before(after);
    for (const Joint& joint : {Joint{after, before, true}, Joint{before, after, false}})
      if (hides_corner(joint, axis.side) && visit(joint))
        return true;
    return false;
  }

 private:
  /// Whether a joint is closed, and the covering side.
  struct Closed {
    bool closed = false;
    Side cover;
  };

  /// Returns whether a joint is closed and hides its corner from side e. The normals of
  /// the surface and of the next side of the covering part bound a cone; the normal of
  /// e must be outside this cone by more than ten degrees.
  bool hides_corner(const Joint& joint, const PairSide& e) {
    const Segment& surface = shape_.at(joint.surface);
    if (!turns_away(surface, e, joint))
      return false;
    const Segment& g = shape_.at(joint.side);
    if (g.is_inner && is_notch(joint.surface_is_before ? g.corner : surface.corner))
      return false;
    const Closed found = find_closed(joint);
    if (!found.closed)
      return false;
    const Side beyond = joint.surface_is_before ? parts_.after(found.cover)
                                                : parts_.before(found.cover);
    const Segment next{at(beyond.start), at(beyond.end), 0.0, beyond.start, false};
    const int ridge = shape_.turn(surface, next);
    return (joint.surface_is_before ? ridge >= 0 : ridge <= 0) ||
           turns_away(next, e, joint);
  }
  /// Returns whether the outline of the block turns inwards at a corner.
  bool is_notch(int corner) {
    return predicates_.re_entrant(at(blocks_.previous[corner]), at(corner),
                                  at(blocks_.next[corner]));
  }
  /// Returns whether side e turns away from the surface
  /// (docs/contact-rule.md#hidden-axes). From the surface to the reversed side e, the
  /// direction has to turn away from the block of the surface. The angle is more than
  /// ten degrees and less than 180.
  bool turns_away(const Segment& surface, const PairSide& e, const Joint& joint) {
    if (shape_.face(surface, shape_.at(e)))
      return false;
    const int turned = shape_.turn(surface, shape_.at(e));
    return joint.surface_is_before ? turned > 0 : turned < 0;
  }

  /// A joint is closed if its surface is an edge and the centroid of the other part is
  /// not inside it. Neighbours also have to cover the side of the joint where the other
  /// part is. An inner side is covered by the part beside it.
  Closed find_closed(const Joint& joint) {
    const Segment &surface = shape_.at(joint.surface), &g = shape_.at(joint.side);
    if (surface.is_inner)
      return {};
    const int part = shape_.part(joint.side.part),
              other = shape_.part(1 - joint.side.part);
    if (!predicates_.may_be_outside(shape_.centroid(1 - joint.side.part), surface.start,
                                    surface.end))
      return {};
    if (g.is_inner)
      return {true, parts_.twin(parts_.side(part, joint.side.index))};
    if (is_surely_uncovered(joint, part, other))
      return {};
    gather(part, other);
    const geometry::Cover found = predicates_.find_cover(
        {scratch_.outlines[0], joint.side.index, joint.surface_is_before},
        scratch_.outlines[1], {scratch_.outlines.begin() + 2, scratch_.outlines.end()});
    if (!found)
      return {};
    return {true, parts_.side(scratch_.parts[static_cast<std::size_t>(found.neighbour)],
                              found.side)};
  }
  /// Most joints are far from closed, so this test comes first.
  bool is_surely_uncovered(const Joint& joint, int part, int other) {
    return dynamics::is_surely_uncovered(
        blocks_, parts_, neighbours_,
        {part, joint.side.index, joint.surface_is_before, other}, 0.0, 0.0, scratch_);
  }
  /// Collects the outlines of the own part, of the other part, and of the parts that
  /// may cover. Covering parts have bounding boxes that meet that of the other part, so
  /// the result does not depend on the length of the list. Parts too far from the own
  /// part are left out.
  void gather(int own, int other) {
    scratch_.parts.clear();
    scratch_.outlines.assign({parts_.outline(blocks_, own, scratch_.own),
                              parts_.outline(blocks_, other, scratch_.other)});
    // No side of a part in the box, and no gap that counts, is longer than this.
    const PartBox near_own = PartBox(blocks_, parts_, own).grown(1.5),
                  of_other(blocks_, parts_, other);
    each_covering_part(blocks_, parts_, neighbours_, own, other, [&](int part) {
      const PartBox box(blocks_, parts_, part);
      if (box.meets(of_other) && box.meets(near_own))
        scratch_.parts.push_back(part);
    });
    if (scratch_.polygons.size() < scratch_.parts.size())
      scratch_.polygons.resize(scratch_.parts.size());
    for (std::size_t k = 0; k < scratch_.parts.size(); ++k)
      scratch_.outlines.push_back(
          parts_.outline(blocks_, scratch_.parts[k], scratch_.polygons[k]));
  }
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }

  const Blocks& blocks_;
  const BlockParts& parts_;
  const Neighbours& neighbours_;
  PairShape<Predicates>& shape_;
  Predicates& predicates_;
  JointScratch& scratch_;
};

}  // namespace blocks::dynamics
