// Which corners of two blocks act on which edges: the contact rule
// (docs/contact-rule.md). A pure function of the two blocks and of the blocks
// that either of them is paired with; every question is answered exactly (geometry/).
// Independent of the contact list and of the time loop. A template over the predicates,
// so that `blocks study` can try others.
#pragma once

#include <algorithm>
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
  bool operator==(const Axis&) const = default;
};

/// Working memory of the rule, one for each thread: it grows to what the largest
/// decision needs and is kept.
struct PairScratch {
  std::vector<Axis> axes;
  std::vector<CornerOnEdge> found;
  std::vector<int> parts;
  std::vector<geometry::Polygon> polygons;
  geometry::Polygon own, other, neighbour;  ///< of parts of blocks that are not convex
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
    if (b < a)  // of equally deep axes one of the lower block comes first
      std::swap(a, b);
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
    ends_are_open_ = false;
    if (b < a)
      std::swap(a, b);
    scratch_.found.clear();
    for (int p = parts_.first_part(a); p < parts_.end_part(a); ++p)
      for (int q = parts_.first_part(b); q < parts_.end_part(b); ++q)
        if (!settle_parts(p, q))
          return false;
    return true;
  }
  /// What was settled acts only if its corner is between the ends of the edge.
  bool ends_are_open() const { return ends_are_open_; }
  Predicates& predicates() { return ask_; }

 private:
  /// The first entered axis acts if it is not hidden. If it is hidden, the surface of a
  /// closed joint takes over, at most twice. Otherwise an axis stands in: the least
  /// one, or the first entered one if the surfaces are hidden too.
  void decide_parts(int p, int q) {
    scratch_.axes.clear();
    if (!find_axes(p, q) || !find_axes(q, p))
      return;
    const Axis least = take_least();
    if (!is_inside(least.corner.start, least.side)) {
      touch(least);
      return;
    }
    std::optional<Axis> entered;
    for (Axis axis = least;; axis = take_least()) {
      if (!Predicates::entry || is_entered(axis)) {
        entered = axis;
        break;
      }
      if (scratch_.axes.empty())
        break;
    }
    if (!entered) {
      stand_in(least);
      return;
    }
    Axis axis = *entered;
    for (int looks = 0; looks < 3; ++looks) {
      const std::optional<Axis> surface = surface_instead_of(axis);
      if (!surface && is_inner(axis.side))
        return;  // the part beside it decides
      if (!surface) {
        if (!touch(axis) && looks == 0)
          stand_in(least);
        return;
      }
      axis = *surface;
    }
    stand_in(*entered);
  }
  /// Adds the corner of the axis on the axis side, if it is between the ends.
  void stand_in(const Axis& axis) {
    if (!is_inner(axis.side) && is_between(axis.corner.start, axis.side))
      add(axis.corner.start, axis.side);
  }
  /// The least axis of the surfaces of all closed joints that hide the axis; of equal
  /// ones, that of the joint that is considered first. None: the axis is not hidden.
  std::optional<Axis> surface_instead_of(const Axis& axis) {
    std::optional<Axis> found;
    const auto consider_surface = [&](const Joint& joint, int other, bool hides) {
      if (!hides)
        return;
      const Axis one = axis_of(joint.surface, other);
      if (!found || is_less(one, *found))
        found = one;
    };
    if (!Predicates::covered_sides)
      return found;
    const auto ends = [&](const Side& side, int other) {
      for (const Joint& joint : {Joint{side, parts_.before(side), true},
                                 Joint{side, parts_.after(side), false}})
        consider_surface(joint, other, is_closed(joint, other).closed);
    };
    Side facing;
    ends(axis.side, axis.corner.part);
    if (find_facing(axis, facing))
      ends(facing, axis.side.part);
    const Side before = parts_.before(axis.corner);
    for (const Joint& joint :
         {Joint{axis.corner, before, true}, Joint{before, axis.corner, false}})
      consider_surface(joint, axis.side.part, is_hidden_in(joint, axis.side));
    return found;
  }

  /// decide_parts as long as nothing moves by more than the room of the predicates: the
  /// contacts that may act, each if its corner is inside its edge. False: that is in
  /// doubt. Let e be a side that is entered by whichever corner may be the deepest
  /// below it. The first entered axis is that of e or one that is not certainly deeper;
  /// which of them it is does not matter if they all belong to the same two faces and
  /// none is hidden.
  bool settle_parts(int p, int q) {
    std::vector<Axis>& axes = scratch_.axes;
    axes.clear();
    for (const auto& [own, other] : {std::pair(p, q), std::pair(q, p)})
      for (int i = 0; i < parts_.corners(own); ++i) {
        const Axis axis = axis_of(parts_.side(own, i), other);
        if (ask_.stays_apart(at(axis.corner.start), start(axis.side), end(axis.side)))
          return true;  // apart: nothing acts
        axes.push_back(axis);
        add_ties(axis);
      }
    std::size_t known = 0;
    for (std::size_t k = 1; k < axes.size(); ++k)
      if (is_less(axes[k], axes[known]))
        known = k;
    Side face;
    const bool faces = is_certain([&] { return find_facing(axes[known], face); });
    const auto same_faces = [&](const Axis& axis) {
      const Axis& least = axes[known];
      Side other;
      return axis == least ||
             (faces && is_certain([&] { return find_facing(axis, other); }) &&
              ((axis.side == least.side && other == face) ||
               (axis.side == face && other == least.side)));
    };
    const auto all_of = [&](const Side& side, const auto& question) {
      return std::all_of(axes.begin(), axes.end(), [&](const Axis& axis) {
        return !(axis.side == side) || question(axis);
      });
    };
    const auto is_surely_entered_by_all = [&](const Side& side) {
      return all_of(side, [&](const Axis& axis) { return is_surely_entered(axis); });
    };
    Axis first = axes[known];
    if (!is_surely_entered_by_all(first.side)) {
      const auto opposite =
          std::find_if(axes.begin(), axes.end(), [&](const Axis& axis) {
            return !(axis.side == first.side) && same_faces(axis);
          });
      if (opposite == axes.end() || !is_surely_entered_by_all(opposite->side))
        return false;
      first = *opposite;
    }
    for (const Axis& axis : axes) {
      const bool is_deeper =
          !(axis.side == first.side) && all_of(first.side, [&](const Axis& one) {
            return is_certain([&] { return is_less(one, axis); });
          });
      if (!is_deeper &&
          (!same_faces(axis) || !is_certain([&] { return !is_hidden(axis); })))
        return false;
    }
    // if nothing acts, an axis would stand in: of the same faces, so it does not act
    // either
    ask_.forget_doubt();
    touch(first);
    return !ask_.is_in_doubt();
  }
  /// The answer is yes, and not in doubt.
  template <class Question> bool is_certain(const Question& question) {
    ask_.forget_doubt();
    return question() && !ask_.is_in_doubt();
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

  bool is_entered(const Axis& axis) {
    return is_inside_part(axis) ||
           (Predicates::crossing && (is_beyond(axis) || sides_cross(axis)));
  }
  /// The same, and not in doubt: for one of the reasons, or the corner is well between
  /// the ends or not, and inside its part if it is.
  bool is_surely_entered(const Axis& axis) {
    return is_certain([&] { return is_inside_part(axis); }) ||
           is_certain([&] { return is_beyond(axis); }) ||
           is_certain([&] { return sides_cross(axis); }) ||
           is_certain([&] { return is_inside_or_beyond(axis); });
  }
  bool is_inside_or_beyond(const Axis& axis) {
    Side facing;
    if (!find_facing(axis, facing))
      return false;
    const Vec2 c = at(axis.corner.start);
    for (int i = 0; i < parts_.corners(axis.side.part); ++i) {
      const Side side = parts_.side(axis.side.part, i);
      if (i == axis.side.index || is_inner(side) ||
          ask_.stays_inside(c, start(side), end(side)))
        continue;
      const bool after = side == parts_.after(axis.side);
      if (!(after || side == parts_.before(axis.side)) ||
          !ask_.inside_if_well_between(c, start(axis.side), end(axis.side), start(side),
                                       end(side), after))
        return false;
    }
    return true;
  }
  /// The corner is inside the part of the side.
  bool is_inside_part(const Axis& axis) {
    Side out;
    return sides_outside(axis.corner.start, axis.side.part, axis.side.index, out) == 0;
  }
  /// A side at the corner faces the axis side, and the corner is beyond an end of that.
  bool is_beyond(const Axis& axis) {
    Side facing;
    return find_facing(axis, facing) &&
           !ask_.well_between(at(axis.corner.start), start(axis.side), end(axis.side));
  }
  /// A side at the corner faces the axis side, and the corner has passed only the next
  /// side there, and that end of the axis side has left the corner's part.
  bool sides_cross(const Axis& axis) {
    Side facing, out, other;
    return find_facing(axis, facing) &&
           sides_outside(axis.corner.start, axis.side.part, axis.side.index, out) ==
               1 &&
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

  /// Whether the centroid of the other part is outside the surface of a joint, and
  /// neighbours cover its side where the other part is. An inner side is covered by the
  /// part beside it.
  Closed is_closed(const Joint& joint, int other) {
    if (is_inner(joint.surface))
      return {};
    if (!ask_.may_be_outside(centroid(other), start(joint.surface), end(joint.surface)))
      return {};
    if (is_inner(joint.side))
      return {true, parts_.twin(joint.side)};
    if (is_surely_uncovered(joint, other))
      return {};
    if constexpr (Predicates::has_room) {
      ask_.doubt();
      return {};
    } else {
      gather(joint.side.part, other);
      const geometry::Cover found = ask_.covering(
          {scratch_.outlines[0], joint.side.index, joint.surface_is_before},
          scratch_.outlines[1],
          {scratch_.outlines.begin() + 2, scratch_.outlines.end()});
      if (!found)
        return {};
      return {true,
              parts_.side(scratch_.parts[static_cast<std::size_t>(found.neighbour)],
                          found.side)};
    }
  }
  /// Most joints are far from closed.
  bool is_surely_uncovered(const Joint& joint, int other) {
    do {
      geometry::UncoveredSide side({outline(joint.side.part, scratch_.own),
                                    joint.side.index, joint.surface_is_before},
                                   outline(other, scratch_.other), ask_.room(),
                                   ask_.room_of_neighbours());
      each_neighbour_part(joint.side.part, other, [&](int part) {
        side.add(outline(part, scratch_.neighbour));
      });
      if (side.is_sure())
        return true;
    } while (ask_.narrow_room_of_neighbours());
    return false;
  }
  /// Calls visit(part) for the parts that may cover: of blocks that the other block is
  /// paired with, at least one of the two free.
  template <class Visit>
  void each_neighbour_part(int own, int other, const Visit& visit) {
    const int own_block = parts_.block(own), other_block = parts_.block(other);
    neighbours_(other_block, [&](int block) {
      if (block != own_block && block != other_block &&
          (blocks_.is_free(block) || blocks_.is_free(other_block)))
        for (int part = parts_.first_part(block); part < parts_.end_part(block); ++part)
          visit(part);
    });
  }
  /// The corners of a part; of a convex block as they stand in the memory.
  geometry::Outline outline(int part, geometry::Polygon& copy) const {
    const auto count = static_cast<std::size_t>(parts_.corners(part));
    if (blocks_.convex[parts_.block(part)])
      return {reinterpret_cast<const Vec2*>(blocks_.corner.data()) +
                  parts_.corner(part, 0),
              count};
    copy.clear();
    for (int i = 0; i < parts_.corners(part); ++i)
      copy.push_back(at(parts_.corner(part, i)));
    return copy;
  }
  /// The outlines of the own part, of the other one, and of the parts that may cover,
  /// but for those that are too far away.
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
  void gather(int own, int other) {
    scratch_.parts.clear();
    scratch_.outlines.assign(
        {outline(own, scratch_.own), outline(other, scratch_.other)});
    scratch_.polygons.clear();
    const Box near_own = box_of(own).grown();
    each_neighbour_part(own, other, [&](int part) {
      if (box_of(part).meets(near_own))
        scratch_.parts.push_back(part);
    });
    scratch_.polygons.resize(scratch_.parts.size());
    for (std::size_t k = 0; k < scratch_.parts.size(); ++k)
      scratch_.outlines.push_back(outline(scratch_.parts[k], scratch_.polygons[k]));
  }
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
  /// The axis is not hidden, so the corners are not hidden either. False: nothing acts.
  bool touch(const Axis& axis) {
    const Side& e = axis.side;
    Side f;
    if (!Predicates::faces || !find_facing(axis, f))
      return consider(axis.corner.start, e);
    bool acts = consider(f.start, e);
    acts |= consider(f.end, e);
    acts |= consider(e.start, f);
    acts |= consider(e.end, f);
    return acts;
  }
  bool consider(int c, const Side& e) {
    if (is_inner(e) || !may_act(c, e))
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

  /// The corner is inside the side and between its ends; with room the first is left
  /// open, and so is the second where it is in doubt.
  bool may_act(int c, const Side& s) {
    if constexpr (Predicates::has_room) {
      const bool in_doubt = ask_.is_in_doubt();
      ask_.forget_doubt();
      const bool between = is_between(c, s), is_open = ask_.is_in_doubt();
      ask_.forget_doubt();
      if (in_doubt)
        ask_.doubt();
      ends_are_open_ = ends_are_open_ || is_open;
      return between || is_open;
    } else {
      return is_inside(c, s) && is_between(c, s);
    }
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
  bool ends_are_open_ = false;
};

}  // namespace blocks::dynamics
