// Which corners of two blocks act on which edges: the contact rule
// (docs/contact-rule.md). A pure function of the two blocks and of the blocks
// that either of them is paired with; every question is answered exactly (geometry/).
// Independent of the contact list and of the time loop. A template over the predicates,
// so that `blocks study` can try others.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/predicates.hpp"
#include "geometry/covered_side.hpp"
#include "geometry/vec2.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// A corner that acts on an edge of another block, named by its first corner.
struct CornerOnEdge {
  int corner = -1, edge = -1;
  bool operator==(const CornerOnEdge&) const = default;
};

/// A side of one part and the corner of another part that is deepest below it.
struct Axis {
  Side side;
  Side corner;  ///< the side that starts in the corner
};

/// Working memory of the rule, one for each thread: it grows to what the largest
/// decision needs and is kept.
struct PairScratch {
  std::vector<Axis> axes;
  std::vector<CornerOnEdge> found;
  std::vector<int> parts;
  std::vector<geometry::Polygon> polygons;
  std::vector<geometry::Outline> outlines;
};

/// Neighbours: `neighbours(b, visit)` calls visit(block) for each block that block b is
/// paired with, in a fixed order.
template <class Predicates, class Neighbours> class PairRule {
 public:
  PairRule(const Blocks& blocks, const BlockParts& parts, const Neighbours& neighbours,
           PairScratch& scratch, Predicates predicates = Predicates())
      : blocks_(blocks), parts_(parts), neighbours_(neighbours), scratch_(scratch),
        ask_(predicates) {}

  /// What acts between two blocks, part by part; no contact twice. Valid until the next
  /// call.
  const std::vector<CornerOnEdge>& decide(int a, int b) {
    scratch_.found.clear();
    for (int p = parts_.first_part(a); p < parts_.end_part(a); ++p)
      for (int q = parts_.first_part(b); q < parts_.end_part(b); ++q)
        decide_parts(p, q);
    return scratch_.found;
  }

  /// With predicates that have room: what may act between two blocks as long as nothing
  /// moves by more than the room; each contact acts if its corner is inside its edge
  /// (19). False: that is in doubt.
  bool settle(int a, int b) {
    scratch_.found.clear();
    for (int p = parts_.first_part(a); p < parts_.end_part(a); ++p)
      for (int q = parts_.first_part(b); q < parts_.end_part(b); ++q)
        if (!settle_parts(p, q))
          return false;
    return true;
  }
  const Predicates& predicates() const { return ask_; }

 private:
  /// The least axis acts that is entered and not hidden and along which anything acts.
  /// If there is none, an axis stands in whose corner is between the ends of its side:
  /// the least entered one, with its corner alone, or else the least one.
  void decide_parts(int p, int q) {
    scratch_.axes.clear();
    if (!find_axes(p, q) || !find_axes(q, p))
      return;
    std::optional<Axis> spare;
    bool spare_is_entered = false;
    while (!scratch_.axes.empty()) {
      const Axis least = take_least();
      if (!is_inside(least.corner.start, least.side)) {
        touch(least);
        return;
      }
      const bool entered = !Predicates::entry || is_entered(least);
      if (entered && !(Predicates::covered_sides && is_hidden(least)) && touch(least))
        return;
      if (is_inner(least.side) || !is_between(least.corner.start, least.side))
        continue;
      if (!spare || (entered && !spare_is_entered))
        spare = least, spare_is_entered = entered;
    }
    if (!spare)
      return;
    if (!spare_is_entered)
      touch(*spare);
    else
      add(spare->corner.start, spare->side);
  }

  /// decide_parts as long as nothing moves by more than the room of the predicates: the
  /// contacts that may act, each if its corner is inside its edge. False: that is in
  /// doubt. Axes that may be the least one are tied; which of them is the least does
  /// not matter if they belong to the same two faces and each is entered and not
  /// hidden.
  bool settle_parts(int p, int q) {
    std::vector<Axis>& axes = scratch_.axes;
    axes.clear();
    for (const auto& [own, other] : {std::pair(p, q), std::pair(q, p)})
      for (int i = 0; i < parts_.corners(own); ++i) {
        const std::size_t first = axes.size();
        axes.push_back(axis_of(parts_.side(own, i), other));
        add_ties(axes[first]);
        bool near = false, in_doubt = false;
        for (std::size_t k = first; k < axes.size(); ++k) {
          ask_.forget_doubt();
          near |= ask_.near_or_inside(at(axes[k].corner.start), start(axes[k].side),
                                      end(axes[k].side));
          in_doubt |= ask_.is_in_doubt();
        }
        if (in_doubt || !near)
          return !in_doubt;  // certainly apart: nothing acts
      }
    Axis least = axes.front();
    for (const Axis& axis : axes)
      if (is_less(axis, least))
        least = axis;
    ask_.forget_doubt();
    Side face_of_least;
    const bool faces = find_facing(least, face_of_least);
    for (const Axis& axis : axes) {
      if (axis.side == least.side && axis.corner == least.corner)
        continue;
      const bool in_doubt = ask_.is_in_doubt();
      if (!is_less(axis, least) && ask_.is_in_doubt() == in_doubt)
        continue;
      Side other_face;
      ask_.forget_doubt();
      if (in_doubt || !faces || !find_facing(axis, other_face) ||
          !((axis.side == least.side && other_face == face_of_least) ||
            (axis.side == face_of_least && other_face == least.side)) ||
          !is_entered(axis) || is_hidden(axis) || ask_.is_in_doubt())
        return false;
    }
    if (!is_entered(least) || is_hidden(least) || ask_.is_in_doubt())
      return false;
    touch(least);
    return !ask_.is_in_doubt();
  }
  /// Adds the axes of the same side with the other corners that may be the deepest.
  void add_ties(const Axis axis) {
    for (int k = 0; k < parts_.corners(axis.corner.part); ++k) {
      if (k == axis.corner.index)
        continue;
      ask_.forget_doubt();
      const int c = parts_.corner(axis.corner.part, k);
      ask_.turn_sign(at(c), at(axis.corner.start), start(axis.side), end(axis.side));
      if (ask_.is_in_doubt())
        scratch_.axes.push_back({axis.side, parts_.side(axis.corner.part, k)});
    }
  }

  // Axes

  /// Adds the axes of the sides of part p against part q. False: one of them keeps the
  /// two apart by more than the slack.
  bool find_axes(int p, int q) {
    for (int i = 0; i < parts_.corners(p); ++i) {
      const Axis axis = axis_of(parts_.side(p, i), q);
      if (!ask_.near_or_inside(at(axis.corner.start), start(axis.side), end(axis.side)))
        return false;
      scratch_.axes.push_back(axis);
    }
    return true;
  }
  Axis axis_of(const Side& side, int q) {
    int deepest = 0;
    for (int k = 1; k < parts_.corners(q); ++k)
      // the way from the deepest corner so far to this one leads deeper
      if (ask_.turn_sign(at(parts_.corner(q, deepest)), at(parts_.corner(q, k)),
                         start(side), end(side)) > 0)
        deepest = k;
    return {side, parts_.side(q, deepest)};
  }
  /// Of equally deep axes the one that was found first.
  Axis take_least() {
    std::vector<Axis>& axes = scratch_.axes;
    std::size_t least = 0;
    for (std::size_t i = 1; i < axes.size(); ++i)
      if (is_less(axes[i], axes[least]))
        least = i;
    const Axis axis = axes[least];
    axes.erase(axes.begin() + static_cast<std::ptrdiff_t>(least));
    return axis;
  }
  bool is_less(const Axis& a, const Axis& b) {
    return ask_.compare_depths(at(a.corner.start), start(a.side), end(a.side),
                               at(b.corner.start), start(b.side), end(b.side)) < 0;
  }

  /// Of the two sides at the corner of an axis the one that faces the axis side, the
  /// more nearly parallel one of two. False: none does.
  bool find_facing(const Axis& axis, Side& facing) {
    const Side after = axis.corner, before = parts_.before(after);
    const bool one = face(axis.side, before), other = face(axis.side, after);
    facing = one ? before : after;
    if (one && other &&
        ask_.compare_slopes(start(axis.side), end(axis.side), start(after), end(after),
                            start(before), end(before)) < 0)
      facing = after;
    return one || other;
  }

  // Entry

  /// The corner is inside the part of the side. Or a side at the corner faces the axis
  /// side, and the corner is beyond an end of that, or sides cross: the corner has
  /// passed only the next side there, and that end of the axis side has left the
  /// corner's part.
  bool is_entered(const Axis& axis) {
    const int c = axis.corner.start;
    Side facing, out, other;
    const bool faces = Predicates::crossing && find_facing(axis, facing);
    if (faces && !ask_.well_between(at(c), start(axis.side), end(axis.side)))
      return true;
    const int count = sides_outside(c, axis.side.part, axis.side.index, out);
    if (count == 0 || !faces)
      return count == 0;
    return count == 1 &&
           ((out == parts_.before(axis.side) &&
             sides_outside(axis.side.start, axis.corner.part, -1, other) > 0) ||
            (out == parts_.after(axis.side) &&
             sides_outside(axis.side.end, axis.corner.part, -1, other) > 0));
  }
  /// How many sides of a part, other than inner ones and side `except`, have the corner
  /// outside, and one of them.
  int sides_outside(int c, int part, int except, Side& out) {
    int count = 0;
    for (int i = 0; i < parts_.corners(part); ++i)
      if (const Side side = parts_.side(part, i);
          i != except && !is_inner(side) && is_outside(c, side))
        out = side, ++count;
    return count;
  }

  // Covered sides

  /// A corner between a side that is covered, or may be, and a side that is a surface.
  struct Joint {
    Side side, surface;
    bool surface_is_before;  ///< the surface ends in the corner, the side starts there
  };
  /// A joint and the covering side.
  struct Closed {
    bool closed = false;
    Side cover;
  };

  /// The axis side or the side that faces it is covered; or the corner is in a closed
  /// joint, and the axis side turns away from the surface there.
  bool is_hidden(const Axis& axis) {
    Side facing;
    return is_covered(axis.side, axis.corner.part) ||
           (find_facing(axis, facing) && is_covered(facing, axis.side.part)) ||
           is_hidden_at_corner(axis.corner, axis.side);
  }
  /// An end of the side is in a closed joint, with this side as the covered one.
  bool is_covered(const Side& side, int other) {
    return is_inner(side) ||
           is_closed({side, parts_.before(side), true}, other).closed ||
           is_closed({side, parts_.after(side), false}, other).closed;
  }
  bool is_hidden_at_corner(const Side& after, const Side& e) {
    const Side before = parts_.before(after);
    return is_hidden_in({after, before, true}, e) ||
           is_hidden_in({before, after, false}, e);
  }
  /// The normal of side e leaves the cone from the surface to the next side of the
  /// covering block by more than ten degrees.
  bool is_hidden_in(const Joint& joint, const Side& e) {
    if (!turns_away(joint.surface, e, joint))
      return false;
    const Closed found = is_closed(joint, e.part);
    if (!found.closed)
      return false;
    const Side beyond = joint.surface_is_before ? parts_.after(found.cover)
                                                : parts_.before(found.cover);
    const int ridge = turn(joint.surface, beyond);
    return (joint.surface_is_before ? ridge >= 0 : ridge <= 0) ||
           turns_away(beyond, e, joint);
  }
  /// From the surface to the side e, run backwards, the direction turns away from the
  /// block of the surface by more than ten degrees and less than 180.
  bool turns_away(const Side& surface, const Side& e, const Joint& joint) {
    if (face(surface, e))
      return false;
    const int turned = turn(surface, e);
    return joint.surface_is_before ? turned > 0 : turned < 0;
  }

  /// Whether neighbours cover the side of a joint where the other part is. An inner
  /// side is covered by the part beside it.
  Closed is_closed(const Joint& joint, int other) {
    if (is_inner(joint.surface))
      return {};
    if (is_inner(joint.side))
      return {true, parts_.twin(joint.side)};
    if (!ask_.may_be_outside(centroid(other), start(joint.surface), end(joint.surface)))
      return {};
    gather(joint.side.part, other);
    if (scratch_.parts.empty())
      return {};
    const geometry::Cover found = ask_.covering(
        {scratch_.outlines[0], joint.side.index, joint.surface_is_before},
        scratch_.outlines[1], {scratch_.outlines.begin() + 2, scratch_.outlines.end()});
    if (!found)
      return {};
    return {true, parts_.side(scratch_.parts[static_cast<std::size_t>(found.neighbour)],
                              found.side)};
  }
  /// The outlines of the own part, of the other one, and of the parts that may cover:
  /// of blocks that the other block is paired with, at least one of the two free, and
  /// not so far away that no side of theirs can cover one of the own part.
  void gather(int own, int other) {
    if (gathered_own_ == own && gathered_other_ == other)
      return;
    gathered_own_ = own, gathered_other_ = other;
    scratch_.parts.clear();
    scratch_.outlines.clear();
    std::size_t used = 0;
    const auto outline = [&](int part) {
      if (used == scratch_.polygons.size())
        scratch_.polygons.emplace_back();
      geometry::Polygon& polygon = scratch_.polygons[used++];
      polygon.clear();
      for (int i = 0; i < parts_.corners(part); ++i)
        polygon.push_back(at(parts_.corner(part, i)));
    };
    outline(own);
    outline(other);
    const Box near_own = box_of(own).grown();
    const int own_block = parts_.block(own), other_block = parts_.block(other);
    neighbours_(other_block, [&](int block) {
      if (block == own_block || block == other_block ||
          !(blocks_.is_free(block) || blocks_.is_free(other_block)))
        return;
      for (int part = parts_.first_part(block); part < parts_.end_part(block); ++part)
        if (box_of(part).meets(near_own)) {
          scratch_.parts.push_back(part);
          outline(part);
        }
    });
    for (std::size_t i = 0; i < used; ++i)
      scratch_.outlines.emplace_back(scratch_.polygons[i]);
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
  Box box_of(int part) const {
    Box box{at(parts_.corner(part, 0)), at(parts_.corner(part, 0))};
    for (int i = 1; i < parts_.corners(part); ++i) {
      const Vec2 corner = at(parts_.corner(part, i));
      box = {box.lower.cwiseMin(corner), box.upper.cwiseMax(corner)};
    }
    return box;
  }
  /// [L] Of a part; of a convex block the block's own.
  Vec2 centroid(int part) const {
    const int block = parts_.block(part);
    if (blocks_.convex[block])
      return blocks_.centroid.col(block);
    Vec2 sum = Vec2::Zero();
    for (int i = 0; i < parts_.corners(part); ++i)
      sum += at(parts_.corner(part, i));
    return sum / parts_.corners(part);
  }

  // Contacts

  /// Adds what acts along an axis: the ends of two faces on each other, or one corner.
  /// False: nothing acts.
  bool touch(const Axis& axis) {
    const Side& e = axis.side;
    Side f;
    if (!Predicates::faces || !find_facing(axis, f)) {
      const int c = axis.corner.start;
      if (!may_act(c, e) || !is_between(c, e) || is_inner(e))
        return false;
      add(c, e);
      return true;
    }
    bool acts = consider(f, e);
    acts |= consider(parts_.after(f), e);
    acts |= consider(e, f);
    acts |= consider(parts_.after(e), f);
    return acts;
  }
  /// The corner in which side `after` starts, on side e.
  bool consider(const Side& after, const Side& e) {
    const int c = after.start;
    if (is_inner(e) || !may_act(c, e) || !is_between(c, e) ||
        (Predicates::covered_sides && is_hidden_at_corner(after, e)))
      return false;
    add(c, e);
    return true;
  }
  void add(int corner, const Side& e) {
    const CornerOnEdge contact{corner, e.start};
    for (const CornerOnEdge& other : scratch_.found)
      if (other == contact)
        return;
    scratch_.found.push_back(contact);
  }

  // Short names

  /// The corner is inside the side; with room that is left open.
  bool may_act(int c, const Side& s) {
    if constexpr (Predicates::has_room)
      return true;
    return is_inside(c, s);
  }

  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  Vec2 start(const Side& s) const { return at(s.start); }
  Vec2 end(const Side& s) const { return at(s.end); }
  bool is_inner(const Side& s) const { return parts_.is_inner(blocks_, s); }
  bool is_inside(int c, const Side& s) {
    return ask_.overlap_sign(at(c), start(s), end(s)) > 0;
  }
  bool is_outside(int c, const Side& s) {
    return ask_.overlap_sign(at(c), start(s), end(s)) < 0;
  }
  bool is_between(int c, const Side& s) {
    return ask_.between(at(c), start(s), end(s));
  }
  bool face(const Side& s, const Side& t) {
    return ask_.edges_face(start(s), end(s), start(t), end(t));
  }
  int turn(const Side& from, const Side& to) {
    return ask_.turn_sign(start(from), end(from), start(to), end(to));
  }

  const Blocks& blocks_;
  const BlockParts& parts_;
  const Neighbours& neighbours_;
  PairScratch& scratch_;
  Predicates ask_;
  int gathered_own_ = -1, gathered_other_ = -1;  ///< the parts in the outlines
};

}  // namespace blocks::dynamics
