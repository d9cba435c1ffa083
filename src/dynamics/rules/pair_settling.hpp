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

  /// Let e be the side of the least axis, and f the side that faces it. If e is entered
  /// by whichever corner may be the deepest below it, the first entered axis is that of
  /// e, or one that is not surely deeper. If e or f is entered, it is that of e or f,
  /// or one that is not surely deeper than both. Which of these axes it is does not
  /// matter if they all belong to the same two faces and these are not hidden.
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
    const bool is_entered =
        all_of(least.side, [&](const Axis& axis) { return is_surely_entered(axis); });
    if (!is_entered && !(face && (is_entered_in_turn(least.side, *face) ||
                                  is_entered_in_turn(*face, least.side))))
      return false;
    for (const Axis& axis : axes) {
      const bool is_deeper = is_surely_deeper(axis, least.side) &&
                             (is_entered || is_surely_deeper(axis, *face));
      if (!is_deeper && !has_same_faces(axis, least, face))
        return false;
    }
    // If nothing acts, an axis would stand in. It is of the same faces, so it does not
    // act either.
    if (!is_certain([&] { return !is_hidden(least, face); }) ||
        !is_certain([&] { return has_no_side_in_line(least, face); }))
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
  /// The answer is yes for all axes of a side.
  template <class Question>
  bool all_of(const PairSide& side, const Question& question) const {
    return std::all_of(
        scratch_.axes.begin(), scratch_.axes.end(),
        [&](const Axis& axis) { return !(axis.side == side) || question(axis); });
  }
  /// The axis is surely deeper than all axes of a side.
  bool is_surely_deeper(const Axis& axis, const PairSide& side) const {
    return !(axis.side == side) && all_of(side, [&](const Axis& one) {
      return shape_.is_surely_deeper(axis, side, one.corner.index);
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
  /// In doubt if a side may be in line with one of these.
  bool has_no_side_in_line(const Axis& axis, const Facing& face) {
    const auto pass = [](const PairSide&) {};
    shape_.each_in_line(axis.side, pass);
    if (face)
      shape_.each_in_line(*face, pass);
    return true;
  }
  bool is_hidden(const Axis& axis, const Facing& face) {
    return shape_.at(axis.side).is_inner || (face && shape_.at(*face).is_inner) ||
           joints_.any_hiding(axis, face, [](const PairSide&) { return true; });
  }

  /// The corner is inside the part of the axis side, or beyond an end of that side.
  bool is_surely_entered(const Axis& axis) {
    return all_inside_but(axis, axis.side) ||
           (is_certain([&] { return shape_.find_facing(axis).has_value(); }) &&
            is_certain([&] { return entry_.is_beyond(axis); }));
  }
  /// One of two faces is entered if only the axes of ends of the other one count for
  /// each of them (docs/contact-rule.md#decisions-that-are-kept).
  bool is_entered_in_turn(const PairSide& side, const PairSide& face) {
    return all_of(side, [&](const Axis& axis) {
      if (axis.corner == face)
        return all_inside_but(axis, shape_.after(side));
      if (axis.corner == shape_.after(face))
        return all_inside_but(axis, shape_.before(side));
      return false;
    });
  }
  /// The corner is inside all sides of the part of the axis side but that one and
  /// another.
  bool all_inside_but(const Axis& axis, const PairSide& another) const {
    for (int i = 0; i < shape_.corners(axis.side.part); ++i)
      if (const PairSide side{axis.side.part, i};
          !(side == axis.side) && !(side == another) &&
          !shape_.depth(side, axis.corner.index).positive())
        return false;
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
