// Which closed joints hide an axis (docs/contact-rule.md#closed-joints, #covered-sides
// and #hidden-axes).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/pair_shape.hpp"
#include "geometry/covered_side.hpp"
#include "geometry/polygon.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// A corner between a side that is covered, or may be, and a side that is a surface.
struct Joint {
  PairSide side, surface;
  bool surface_is_before;  ///< the surface ends in the corner, the side starts there
};

/// Working memory of ClosedJoints.
struct JointScratch {
  std::vector<int> parts;
  std::vector<geometry::Polygon> polygons;
  geometry::Polygon own, other, neighbour;  ///< of parts of blocks that are not convex
  std::vector<geometry::Outline> outlines;
};

/// Calls visit(part) for the parts that may cover a side of part `own` where part
/// `other` is: those of blocks that the other block is paired with, at least one of the
/// two free. Neighbours: see ClosedJoints.
template <class Neighbours, class Visit>
void each_covering_part(const Blocks& blocks, const BlockParts& parts,
                        const Neighbours& neighbours, int own, int other,
                        const Visit& visit) {
  const int own_block = parts.block(own), other_block = parts.block(other);
  neighbours(other_block, [&](int block) {
    if (block != own_block && block != other_block &&
        (blocks.is_free(block) || blocks.is_free(other_block)))
      for (int part = parts.first_part(block); part < parts.end_part(block); ++part)
        visit(part);
  });
}

/// A side of a part, one of its ends, and the other part.
struct SideOfJoint {
  int part, side;
  bool at_start;
  int other;
};

/// Whether neighbours certainly do not cover the side of a joint, now and after any
/// motion that leaves room (geometry::UncoveredSide).
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

/// Neighbours: `neighbours(b, visit)` calls visit(block) for each block that block b is
/// paired with, in a fixed order.
template <class Predicates, class Neighbours> class ClosedJoints {
 public:
  ClosedJoints(const Blocks& blocks, const BlockParts& parts,
               const Neighbours& neighbours, PairShape<Predicates>& shape,
               Predicates& ask, JointScratch& scratch)
      : blocks_(blocks), parts_(parts), neighbours_(neighbours), shape_(shape),
        ask_(ask), scratch_(scratch) {}

  /// Calls visit(surface) for the joints that hide an axis until one returns true, and
  /// returns whether one did. Joints at the corner are tested only without a facing
  /// side: with one, they are joints at its ends, or their surface faces the axis side.
  template <class Visit>
  bool any_hiding(const Axis& axis, const std::optional<PairSide>& facing,
                  const Visit& visit) {
    const auto at_ends = [&](const PairSide& g) {
      for (const Joint& joint :
           {Joint{g, shape_.before(g), true}, Joint{g, shape_.after(g), false}})
        if (find_closed(joint).closed && visit(joint.surface))
          return true;
      return false;
    };
    if (at_ends(axis.side))
      return true;
    if (facing)
      return at_ends(*facing);
    const PairSide after = axis.corner, before = shape_.before(after);
    for (const Joint& joint : {Joint{after, before, true}, Joint{before, after, false}})
      if (hides_corner(joint, axis.side) && visit(joint.surface))
        return true;
    return false;
  }

 private:
  /// A joint and the covering side.
  struct Closed {
    bool closed = false;
    Side cover;
  };

  /// The normal of side e leaves the cone from the surface to the next side of the
  /// covering block by more than ten degrees.
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
  /// The outline of the block turns inwards at a corner.
  bool is_notch(int corner) {
    return ask_.re_entrant(at(blocks_.previous[corner]), at(corner),
                           at(blocks_.next[corner]));
  }
  /// From the surface to the side e, run backwards, the direction turns away from the
  /// block of the surface by more than ten degrees and less than 180.
  bool turns_away(const Segment& surface, const PairSide& e, const Joint& joint) {
    if (shape_.face(surface, shape_.at(e)))
      return false;
    const int turned = shape_.turn(surface, shape_.at(e));
    return joint.surface_is_before ? turned > 0 : turned < 0;
  }

  /// Whether the centroid of the other part is outside the surface of a joint, and
  /// neighbours cover its side where the other part is. An inner side is covered by the
  /// part beside it.
  Closed find_closed(const Joint& joint) {
    const Segment &surface = shape_.at(joint.surface), &g = shape_.at(joint.side);
    if (surface.is_inner)
      return {};
    const int part = shape_.part(joint.side.part),
              other = shape_.part(1 - joint.side.part);
    if (!ask_.may_be_outside(shape_.centroid(1 - joint.side.part), surface.start,
                             surface.end))
      return {};
    if (g.is_inner)
      return {true, parts_.twin(parts_.side(part, joint.side.index))};
    if (is_surely_uncovered(joint, part, other))
      return {};
    gather(part, other);
    const geometry::Cover found = ask_.covering(
        {scratch_.outlines[0], joint.side.index, joint.surface_is_before},
        scratch_.outlines[1], {scratch_.outlines.begin() + 2, scratch_.outlines.end()});
    if (!found)
      return {};
    return {true, parts_.side(scratch_.parts[static_cast<std::size_t>(found.neighbour)],
                              found.side)};
  }
  /// Most joints are far from closed.
  bool is_surely_uncovered(const Joint& joint, int part, int other) {
    return dynamics::is_surely_uncovered(
        blocks_, parts_, neighbours_,
        {part, joint.side.index, joint.surface_is_before, other}, 0.0, 0.0, scratch_);
  }
  struct Box {
    Vec2 lower, upper;
    bool meets(const Box& other) const {
      return (lower.array() <= other.upper.array()).all() &&
             (other.lower.array() <= upper.array()).all();
    }
    /// By more than its extents together: no side of what is in the box is longer, nor
    /// is a gap that counts.
    Box grown() const {
      const double by = 1.5 * (upper - lower).sum();
      return {lower.array() - by, upper.array() + by};
    }
  };
  /// The outlines of the own part, of the other one, and of the parts that may cover:
  /// their boxes meet that of the other part, whatever list they are from. Parts that
  /// are too far away are left out.
  void gather(int own, int other) {
    scratch_.parts.clear();
    scratch_.outlines.assign({parts_.outline(blocks_, own, scratch_.own),
                              parts_.outline(blocks_, other, scratch_.other)});
    const Box near_own = box_of(own).grown(), of_other = box_of(other);
    each_covering_part(blocks_, parts_, neighbours_, own, other, [&](int part) {
      const Box box = box_of(part);
      if (box.meets(of_other) && box.meets(near_own))
        scratch_.parts.push_back(part);
    });
    if (scratch_.polygons.size() < scratch_.parts.size())
      scratch_.polygons.resize(scratch_.parts.size());
    for (std::size_t k = 0; k < scratch_.parts.size(); ++k)
      scratch_.outlines.push_back(
          parts_.outline(blocks_, scratch_.parts[k], scratch_.polygons[k]));
  }
  Box box_of(int part) const {
    Box box{at(parts_.corner(part, 0)), at(parts_.corner(part, 0))};
    for (int i = 1; i < parts_.corners(part); ++i) {
      const Vec2 corner = at(parts_.corner(part, i));
      box = {box.lower.cwiseMin(corner), box.upper.cwiseMax(corner)};
    }
    return box;
  }
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }

  const Blocks& blocks_;
  const BlockParts& parts_;
  const Neighbours& neighbours_;
  PairShape<Predicates>& shape_;
  Predicates& ask_;
  JointScratch& scratch_;
};

}  // namespace blocks::dynamics
