// The sides of two convex parts, and how deep each corner of one part is below each
// side of the other (docs/contact-rule.md#depth-and-axis).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "geometry/contact_predicates.hpp"
#include "geometry/vec2.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

using geometry::Vec2;

/// The current position of a side of a part.
struct Segment {
  Vec2 start, end;
  double per_length;  ///< [1/L] geometry::filter::per_length
  int corner;         ///< number of the corner where it starts
  bool is_inner;
};

/// Side `index` of part 0 or part 1 of a pair. It also names the corner where the side
/// starts.
struct PairSide {
  int part = 0, index = 0;
  bool operator==(const PairSide&) const = default;
};

/// A side of one part and the corner of the other part that is deepest below it.
struct Axis {
  PairSide side, corner;
  bool operator==(const Axis&) const = default;
};

/// A part and the depths below its sides.
struct PartShape {
  int part = -1;
  std::vector<Segment> sides;
  /// [L] depths[i * corners + k] is the depth of corner k of the other part below side
  /// i. `corners` is the number of corners of the other part.
  std::vector<geometry::filter::Estimate> depths;
};
using PairMemory = std::array<PartShape, 2>;

class PairShape {
 public:
  explicit PairShape(PairMemory& memory) : parts_(memory) {}

  /// Copies the current corners of two parts. The depths are computed later, one side
  /// at a time (find_depths).
  void take(const Blocks& blocks, const BlockParts& parts, int p, int q) {
    take_part(blocks, parts, p, parts_[0]);
    take_part(blocks, parts, q, parts_[1]);
    for (const int part : {0, 1})
      parts_[part].depths.resize(parts_[0].sides.size() * parts_[1].sides.size());
  }
  int part(int k) const { return parts_[k].part; }
  int corners(int k) const { return static_cast<int>(parts_[k].sides.size()); }
  const Segment& at(const PairSide& s) const {
    return parts_[s.part].sides[static_cast<std::size_t>(s.index)];
  }
  PairSide before(const PairSide& s) const {
    return {s.part, (s.index > 0 ? s.index : corners(s.part)) - 1};
  }
  PairSide after(const PairSide& s) const {
    return {s.part, s.index + 1 < corners(s.part) ? s.index + 1 : 0};
  }

  /// Computes the depths below a side. Returns its axis with the corner that is deepest
  /// by the rounded depths.
  Axis find_depths(const PairSide& s) {
    const int other = 1 - s.part, count = corners(other);
    const Segment& e = at(s);
    geometry::filter::Estimate* const depths = row(s);
    int deepest = 0;
    for (int k = 0; k < count; ++k) {
      depths[k] =
          geometry::filter::depth(at({other, k}).start, e.start, e.end, e.per_length);
      deepest = depths[k].value > depths[deepest].value ? k : deepest;
    }
    return {s, {other, deepest}};
  }
  const geometry::filter::Estimate& depth(const PairSide& s, int corner) const {
    return row(s)[corner];
  }
  const geometry::filter::Estimate& depth(const Axis& axis) const {
    return depth(axis.side, axis.corner.index);
  }
  /// Returns the axis of a side. Equally deep corners follow each other. For a side of
  /// part 0 the last of them clockwise counts, for a side of part 1 the first.
  Axis axis_of(const PairSide& s) {
    const Axis axis = find_depths(s);
    const int other = axis.corner.part, count = corners(other);
    bool is_certain = true;
    for (int k = 0; k < count; ++k)
      is_certain =
          is_certain && (k == axis.corner.index || is_surely_deeper(axis, s, k));
    if (is_certain)
      return axis;
    PairSide deepest{other, 0};
    for (int k = 1; k < count; ++k)
      if (compare_corners(s, deepest.index, k) > 0)
        deepest.index = k;
    const auto next = [&] { return s.part == 0 ? after(deepest) : before(deepest); };
    for (int k = 1; k < count; ++k)
      if (compare_corners(s, deepest.index, next().index) == 0)
        deepest = next();
      else
        break;
    return {s, deepest};
  }
  /// Compares the depths of two corners of the other part below a side. Returns a
  /// positive number if corner l is deeper than corner k, 0 if they are equally deep.
  int compare_corners(const PairSide& s, int k, int l) {
    const int other = 1 - s.part;
    const Segment& e = at(s);
    return geometry::turn_sign(at({other, k}).start, at({other, l}).start, e.start,
                               e.end);
  }
  /// Returns whether the depth of an axis is certainly larger than that of corner k
  /// below side s. If the result is false, either may be larger.
  bool is_surely_deeper(const Axis& axis, const PairSide& s, int k) const {
    const auto &a = depth(axis), &b = depth(s, k);
    return a.value - b.value > (1.0 + 1e-9) * (a.bound + b.bound);
  }
  /// Finds the axes of all sides. Returns false if one of them separates the two parts
  /// by more than the slack.
  bool find_axes(std::vector<Axis>& axes) {
    axes.clear();
    for (const int part : {0, 1})
      for (int i = 0; i < corners(part); ++i) {
        const Axis axis = axis_of({part, i});
        const Segment& e = at(axis.side);
        if (!depth(axis).positive() &&
            !geometry::near_or_inside(at(axis.corner).start, e.start, e.end)) {
          separating_ = axis;
          return false;
        }
        axes.push_back(axis);
      }
    return true;
  }
  /// The axis by whose side find_axes has found the two parts separated.
  const Axis& separating() const { return separating_; }
  /// Removes the least axis from a list and returns it. Of equally deep axes it is the
  /// one that was found first.
  Axis take_least(std::vector<Axis>& axes) {
    std::size_t min = 0;
    for (std::size_t i = 1; i < axes.size(); ++i)
      if (is_less(axes[i], axes[min]))
        min = i;
    const Axis axis = axes[min];
    axes.erase(axes.begin() + static_cast<std::ptrdiff_t>(min));
    return axis;
  }
  /// Returns whether the first axis is less deep than the second one.
  bool is_less(const Axis& a, const Axis& b) {
    if (is_surely_deeper(b, a.side, a.corner.index))
      return true;
    if (is_surely_deeper(a, b.side, b.corner.index))
      return false;
    const Segment &e = at(a.side), &f = at(b.side);
    return geometry::compare_depths(at(a.corner).start, e.start, e.end,
                                    at(b.corner).start, f.start, f.end) < 0;
  }

  /// Returns -1 if a corner of the other part is outside a side, +1 if it is inside,
  /// and 0 if it is on the side's line.
  int depth_sign(const PairSide& s, int corner) {
    const Segment& e = at(s);
    const geometry::filter::Estimate& of = depth(s, corner);
    if (of.positive())
      return 1;
    return of.negative()
               ? -1
               : geometry::overlap_sign(at({1 - s.part, corner}).start, e.start, e.end);
  }
  /// Calls visit(side) for a side and the sides of its part in line with it: first the
  /// side itself, then the sides before it, then those after it.
  template <class Visit> void each_in_line(const PairSide& s, const Visit& visit) {
    const auto run_on = [&](const PairSide& first, const PairSide& next) {
      return in_line(at(first).start, at(first).end, at(next).end);
    };
    visit(s);
    for (PairSide side = before(s); run_on(side, after(side)); side = before(side))
      visit(side);
    for (PairSide side = after(s); run_on(before(side), side); side = after(side))
      visit(side);
  }

  /// Calls visit(corner, side) for each contact that may act along an axis. With a
  /// facing side, these are the ends of each face on the other face; otherwise it is
  /// the corner of the axis. A face may consist of several sides in line. The ends of
  /// inner sides in line with the axis side are left out.
  template <class Visit>
  void each_along(const Axis& axis, const std::optional<PairSide>& facing,
                  const Visit& visit) {
    if (!facing)
      return visit(axis.corner, axis.side);
    each_in_line(*facing, [&](const PairSide& side) {
      visit(side, axis.side);
      visit(after(side), axis.side);
    });
    each_in_line(axis.side, [&](const PairSide& side) {
      if (at(side).is_inner)
        return;
      visit(side, *facing);
      visit(after(side), *facing);
    });
  }

  /// Returns the side at the corner of an axis that faces the axis side. If both sides
  /// at the corner face it, returns the more nearly parallel one.
  std::optional<PairSide> find_facing(const Axis& axis) {
    const PairSide after = axis.corner, before = this->before(after);
    const Segment& e = at(axis.side);
    const Segment &b = at(before), &a = at(after);
    const bool one = face(e, b), other = face(e, a);
    if (one && other)
      return geometry::compare_slopes(e.start, e.end, a.start, a.end, b.start, b.end) <
                     0
                 ? after
                 : before;
    if (one)
      return before;
    return other ? std::optional(after) : std::nullopt;
  }
  /// Returns whether two sides run against each other within ten degrees (20).
  bool face(const Segment& s, const Segment& t) {
    return geometry::edges_face(s.start, s.end, t.start, t.end);
  }

 private:
  /// Returns whether the side p2 q is in line with the side p1 p2 before it: the far
  /// corner of each is within the slack of the other side's line.
  static bool in_line(const Vec2& p1, const Vec2& p2, const Vec2& q) {
    return (p2 - p1).dot(q - p2) > 0.0 && geometry::near_or_inside(q, p2, p1) &&
           geometry::near_or_inside(p1, q, p2);
  }
  /// Copies the sides of a part.
  static void take_part(const Blocks& blocks, const BlockParts& parts, int part,
                        PartShape& shape) {
    shape.part = part;
    shape.sides.resize(static_cast<std::size_t>(parts.corners(part)));
    for (int i = 0; i < parts.corners(part); ++i) {
      const Side side = parts.side(part, i);
      const Vec2 start = blocks.corner.col(side.start),
                 end = blocks.corner.col(side.end);
      shape.sides[static_cast<std::size_t>(i)] = {
          start, end, geometry::filter::per_length(start, end), side.start,
          parts.is_inner(blocks, side)};
    }
  }
  geometry::filter::Estimate* row(const PairSide& s) {
    return &parts_[s.part]
                .depths[static_cast<std::size_t>(s.index * corners(1 - s.part))];
  }
  const geometry::filter::Estimate* row(const PairSide& s) const {
    return &parts_[s.part]
                .depths[static_cast<std::size_t>(s.index * corners(1 - s.part))];
  }

  PairMemory& parts_;
  Axis separating_;
};

}  // namespace blocks::dynamics
