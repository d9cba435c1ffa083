// What may act between two blocks for some time: the contact rule with room for motion
// (docs/contact-rule.md#decisions-that-are-kept).
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "dynamics/rules/pair_rule.hpp"

namespace blocks::dynamics {

template <class Neighbours> class PairSettling {
 public:
  PairSettling(const Blocks& blocks, const BlockParts& parts,
               const Neighbours& neighbours, PairScratch& scratch,
               const PredicatesWithRoom& predicates)
      : blocks_(blocks), parts_(parts), scratch_(scratch), ask_(predicates),
        joints_(blocks, parts, neighbours, shape_, ask_, scratch.joints) {}

  /// Finds what may act between two blocks as long as nothing moves by more than the
  /// room; each contact acts if its corner is inside its edge (19). False: that is in
  /// doubt.
  bool settle(int a, int b) {
    ends_are_open_ = false;
    scratch_.found.clear();
    bool settled = true;
    each_pair_of_parts(parts_, a, b,
                       [&](int p, int q) { settled = settled && settle_parts(p, q); });
    return settled;
  }
  /// What was settled acts only if its corner is between the ends of the edge.
  bool ends_are_open() const { return ends_are_open_; }
  /// [L] How much of it is left for neighbours; 0: they do not count.
  double room_of_neighbours() {
    return ask_.asked_neighbours() ? ask_.room_of_neighbours() : 0.0;
  }

 private:
  using Facing = std::optional<PairSide>;

  /// Let e be a side that is entered by whichever corner may be the deepest below it.
  /// The first entered axis is that of e or one that is not certainly deeper; which of
  /// them it is does not matter if they all belong to the same two faces and these are
  /// not hidden.
  bool settle_parts(int p, int q) {
    shape_.take(blocks_, parts_, p, q);
    if (!find_axes())
      return true;  // apart: nothing acts
    add_ties();
    const std::vector<Axis>& axes = scratch_.axes;
    const Axis least =
        *std::min_element(axes.begin(), axes.end(), [&](const Axis& a, const Axis& b) {
          return shape_.depth(a).value < shape_.depth(b).value;
        });
    ask_.forget_doubt();
    const Facing face = shape_.find_facing(least);
    if (ask_.is_in_doubt())
      return false;
    const std::optional<Axis> first = find_surely_entered(least, face);
    if (!first)
      return false;
    for (const Axis& axis : axes)
      if (!is_surely_deeper(axis, *first) && !has_same_faces(axis, least, face))
        return false;
    // If nothing acts, an axis would stand in. It is of the same faces, so it does not
    // act either.
    if (!is_certain([&] { return !is_hidden(least, face); }))
      return false;
    touch(least, face);
    return true;
  }

  /// The axes of all sides. False: one of them keeps the two apart.
  bool find_axes() {
    scratch_.axes.clear();
    for (const int part : {0, 1})
      for (int i = 0; i < shape_.corners(part); ++i) {
        const Axis axis = shape_.find_depths({part, i});
        const Segment& e = shape_.at(axis.side);
        if (ask_.stays_apart(shape_.depth(axis), e.start, e.end))
          return false;
        scratch_.axes.push_back(axis);
      }
    return true;
  }
  /// Adds the axes of the same sides with the other corners that may be the deepest.
  void add_ties() {
    const std::size_t sides = scratch_.axes.size();
    for (std::size_t a = 0; a < sides; ++a) {
      const Axis axis = scratch_.axes[a];
      for (int k = 0; k < shape_.corners(axis.corner.part); ++k) {
        if (k == axis.corner.index || shape_.is_surely_deeper(axis, axis.side, k))
          continue;
        ask_.forget_doubt();
        const bool is_deeper =
            shape_.compare_corners(axis.side, k, axis.corner.index) > 0;
        if (!is_deeper || ask_.is_in_doubt())
          scratch_.axes.push_back({axis.side, {axis.corner.part, k}});
      }
    }
  }
  /// The least axis if all axes of its side are surely entered, otherwise one of the
  /// same faces from the opposite side.
  std::optional<Axis> find_surely_entered(const Axis& least, const Facing& face) {
    const std::vector<Axis>& axes = scratch_.axes;
    const auto are_entered = [&](const PairSide& side) {
      return std::all_of(axes.begin(), axes.end(), [&](const Axis& axis) {
        return !(axis.side == side) || is_surely_entered(axis);
      });
    };
    if (are_entered(least.side))
      return least;
    const auto opposite = std::find_if(axes.begin(), axes.end(), [&](const Axis& axis) {
      return !(axis.side == least.side) && has_same_faces(axis, least, face);
    });
    if (opposite == axes.end() || !are_entered(opposite->side))
      return std::nullopt;
    return *opposite;
  }
  /// The axis is surely deeper than all axes of the side of another one.
  bool is_surely_deeper(const Axis& axis, const Axis& first) {
    return !(axis.side == first.side) &&
           std::all_of(
               scratch_.axes.begin(), scratch_.axes.end(), [&](const Axis& one) {
                 return !(one.side == first.side) ||
                        shape_.is_surely_deeper(axis, one.side, one.corner.index);
               });
  }
  /// The axis is the least one, or surely belongs to the same two sides, which face
  /// each other.
  bool has_same_faces(const Axis& axis, const Axis& least, const Facing& face) {
    if (axis == least)
      return true;
    if (!face || !(axis.side == least.side || axis.side == *face))
      return false;
    const PairSide& other = axis.side == least.side ? *face : least.side;
    return is_certain([&] { return shape_.find_facing(axis) == other; });
  }
  bool is_hidden(const Axis& axis, const Facing& face) {
    return shape_.at(axis.side).is_inner || (face && shape_.at(*face).is_inner) ||
           joints_.any_hiding(axis, face, [](const PairSide&) { return true; });
  }

  /// For one of the reasons of Entry, or because the corner is well between the ends or
  /// not, and inside its part if it is.
  bool is_surely_entered(const Axis& axis) {
    PairSide out;
    if (is_certain([&] { return sides_outside(axis, out) == 0; }))
      return true;
    if (!is_certain([&] { return shape_.find_facing(axis).has_value(); }))
      return false;
    return is_certain([&] { return entry_.is_beyond(axis); }) || is_certain([&] {
             return sides_outside(axis, out) == 1 && entry_.sides_cross(axis, out);
           }) ||
           is_inside_or_beyond(axis);
  }
  int sides_outside(const Axis& axis, PairSide& out) {
    return shape_.sides_outside(axis.corner, axis.side.index, out);
  }
  bool is_inside_or_beyond(const Axis& axis) {
    const Vec2& c = shape_.at(axis.corner).start;
    const Segment& e = shape_.at(axis.side);
    const PairSide before = shape_.before(axis.side), after = shape_.after(axis.side);
    for (int i = 0; i < shape_.corners(axis.side.part); ++i) {
      const PairSide side{axis.side.part, i};
      const Segment& g = shape_.at(side);
      if (i == axis.side.index || g.is_inner ||
          shape_.depth(side, axis.corner.index).positive())
        continue;
      if (!(side == after || side == before) ||
          !ask_.inside_if_well_between(c, e.start, e.end, g.start, g.end,
                                       side == after))
        return false;
    }
    return true;
  }

  /// Adds what may act along an axis.
  void touch(const Axis& axis, const Facing& face) {
    each_along(shape_, axis, face, [&](const PairSide& corner, const PairSide& side) {
      const Segment& e = shape_.at(side);
      ask_.forget_doubt();
      const bool between = ask_.between(shape_.at(corner).start, e.start, e.end);
      if (between || ask_.is_in_doubt())
        scratch_.add({shape_.at(corner).corner, e.corner});
      ends_are_open_ = ends_are_open_ || ask_.is_in_doubt();
    });
  }
  /// The answer is yes, and not in doubt.
  template <class Question> bool is_certain(const Question& question) {
    ask_.forget_doubt();
    return question() && !ask_.is_in_doubt();
  }

  const Blocks& blocks_;
  const BlockParts& parts_;
  PairScratch& scratch_;
  PredicatesWithRoom ask_;
  PairShape<PredicatesWithRoom> shape_{scratch_.shape, ask_};
  Entry<PredicatesWithRoom> entry_{shape_, ask_};
  ClosedJoints<PredicatesWithRoom, Neighbours> joints_;
  bool ends_are_open_ = false;
};

}  // namespace blocks::dynamics
