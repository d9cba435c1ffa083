// The overlap region of two parts, which bounds the depth of their contacts
// (docs/contact-rule.md#overlap-region).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "dynamics/rules/pair_shape.hpp"
#include "geometry/overlap_region.hpp"

namespace blocks::dynamics {

/// Bounds of a length, [L].
struct LengthBounds {
  double low = 0.0, high = std::numeric_limits<double>::infinity();
};

/// Bounds of the part of a side that is behind several lines. The two ends are given in
/// [0, 1] along the side.
class SegmentBounds {
 public:
  /// Cuts the side at a line, from the depths of its two ends below the line.
  void cut(const geometry::filter::Estimate& first,
           const geometry::filter::Estimate& last) {
    // The factor is for the rounding of the sums below.
    const double a = (1.0 + 1e-9) * first.bound, b = (1.0 + 1e-9) * last.bound;
    if (!(a + b < std::numeric_limits<double>::infinity())) {
      is_known_ = false;
      return;
    }
    const auto zero = [](double from, double to) { return from / (from - to); };
    const double first_low = first.value - a, first_high = first.value + a;
    const double last_low = last.value - b, last_high = last.value + b;
    if (first_low > 0.0 && last_low < 0.0)
      to_low_ = std::min(to_low_, zero(first_low, last_low));
    if (first_high > 0.0 && last_high < 0.0)
      to_high_ = std::min(to_high_, zero(first_high, last_high));
    if (first_low < 0.0 && last_low > 0.0)
      from_high_ = std::max(from_high_, zero(first_low, last_low));
    if (first_high < 0.0 && last_high > 0.0)
      from_low_ = std::max(from_low_, zero(first_high, last_high));
    if (first_low <= 0.0 && last_low <= 0.0)
      to_low_ = -1.0;
    if (first_high < 0.0 && last_high < 0.0)
      to_high_ = -1.0;
  }
  /// Returns a position in the part. It is certain if the lower bound of the length is
  /// positive.
  double middle() const { return 0.5 * (from_high_ + to_low_); }
  /// Returns bounds of the length of the part of a side with this length.
  LengthBounds length(double of_side) const {
    if (!is_known_ || !(of_side < std::numeric_limits<double>::infinity()))
      return {};
    // Positions along the side have a rounding error below 1e-15.
    const double low = to_low_ - from_high_ - 1e-12,
                 high = to_high_ - from_low_ + 1e-12;
    return {low > 0.0 ? low * of_side * (1.0 - 1e-12) : 0.0,
            to_high_ < 0.0 || high < 0.0 ? 0.0 : high * of_side * (1.0 + 1e-12)};
  }

 private:
  double from_low_ = 0.0, from_high_ = 0.0, to_low_ = 1.0, to_high_ = 1.0;
  bool is_known_ = true;
};

/// Working memory of OverlapRegion.
struct OverlapMemory {
  geometry::Polygon part[2];
  std::vector<Vec2> joints;  ///< vertices that were added to the region
};

/// Answers questions about the overlap region of the two parts of a PairShape. The
/// depths below all sides of both parts must have been found. Bounds in doubles decide
/// most questions, and rationals decide the rest.
template <class Predicates> class OverlapRegion {
 public:
  OverlapRegion(const PairShape<Predicates>& shape, OverlapMemory& memory)
      : shape_(shape), memory_(memory) {}

  /// Begins with the two parts that the shape has taken, and their least axis.
  void begin(const Axis& least) {
    least_ = least;
    memory_.joints.clear();
    has_bounds_ = has_outlines_ = false;
  }
  /// Adds the corner of a joint to the vertices of the region. A side names it that
  /// starts there.
  void extend(const PairSide& joint) {
    memory_.joints.push_back(shape_.at(joint).start);
    has_bounds_ = false;
  }

  /// Returns whether a corner is so deep below a side that the two parts cannot have
  /// entered each other through it.
  bool is_far(const PairSide& side, int corner) {
    if (!Predicates::far_sides)
      return false;
    const Segment& e = shape_.at(side);
    const geometry::filter::Estimate depth = shape_.depth(side, corner);
    const geometry::filter::Estimate shift = shape_.depth(least_);
    const double slack = geometry::contact_slack / e.per_length;
    const auto is_surely_near = [&](double length) {
      return depth.value + depth.bound <
             (geometry::far_factor * length + slack) * (1.0 - 1e-9);
    };
    const auto is_surely_far = [&](double length) {
      return depth.value - depth.bound >
             (geometry::far_factor * length + slack) * (1.0 + 1e-9);
    };
    if (is_surely_near(shift.value - shift.bound))
      return false;
    find_bounds();
    if (is_surely_near(diameter_.low))
      return false;
    if (diameter_.low > 0.0 && is_surely_far(diameter_.high) &&
        is_surely_far(shift.value + shift.bound))
      return true;
    const Segment& f = shape_.at(least_.side);
    return geometry::exact::is_far(shape_.at({1 - side.part, corner}).start, e.start,
                                   e.end, shape_.at(least_.corner).start, f.start,
                                   f.end, outline(0), outline(1), memory_.joints);
  }
  /// Returns whether the shallower end of the facing side of an axis, or its corner if
  /// it has none, is far.
  bool is_far(const Axis& axis, const std::optional<PairSide>& facing) {
    return is_far(axis.side, axis.corner.index) &&
           (!facing || (is_far(axis.side, facing->index) &&
                        is_far(axis.side, shape_.after(*facing).index)));
  }
  /// Returns whether a side has a segment of positive length in the other part.
  bool has_segment(const PairSide& side) {
    const LengthBounds length = length_of(find_segment(side), side);
    if (length.low > 0.0)
      return true;
    return length.high > 0.0 &&
           geometry::exact::has_segment(outline(side.part), side.index,
                                        outline(1 - side.part));
  }

 private:
  SegmentBounds find_segment(const PairSide& side) const {
    const int other = 1 - side.part, next = shape_.after(side).index;
    SegmentBounds segment;
    for (int k = 0; k < shape_.corners(other); ++k)
      segment.cut(shape_.depth({other, k}, side.index), shape_.depth({other, k}, next));
    return segment;
  }
  LengthBounds length_of(const SegmentBounds& segment, const PairSide& side) const {
    return segment.length(1.0 / shape_.at(side).per_length);
  }
  /// Bounds the diameter. It is at least the length of the longest segment, and at most
  /// half the length of the border, which consists of all segments.
  void find_bounds() {
    if (has_bounds_)
      return;
    has_bounds_ = true;
    diameter_ = {0.0, 0.0};
    PairSide longest;
    double middle = 0.0;
    for (const int part : {0, 1})
      for (int i = 0; i < shape_.corners(part); ++i) {
        const PairSide side{part, i};
        const SegmentBounds segment = find_segment(side);
        const LengthBounds length = length_of(segment, side);
        if (length.low > diameter_.low)
          longest = side, middle = segment.middle(), diameter_.low = length.low;
        diameter_.high += 0.5 * length.high;
      }
    if (!memory_.joints.empty())
      include_joints(longest, middle);
  }
  /// Bounds the diameter with the added vertices. A point of the region, at a position
  /// on a side, is nearer to each of them than the vertex of the region farthest from
  /// it, and nearer to every vertex of the region than the diameter.
  void include_joints(const PairSide& side, double position) {
    if (!(diameter_.low > 0.0)) {
      diameter_.high = std::numeric_limits<double>::infinity();
      return;
    }
    const Segment& s = shape_.at(side);
    const Vec2 along = s.end - s.start;
    for (const Vec2& joint : memory_.joints) {
      const Vec2 from = s.start - joint;
      const double distance = (from + position * along).norm(),
                   rounding = 1e-14 * (from.lpNorm<1>() + along.lpNorm<1>());
      diameter_.low = std::max(diameter_.low, distance - rounding);
      diameter_.high += distance + rounding;
    }
  }
  geometry::Outline outline(int part) {
    if (!has_outlines_)
      for (const int k : {0, 1}) {
        memory_.part[k].clear();
        for (int i = 0; i < shape_.corners(k); ++i)
          memory_.part[k].push_back(shape_.at({k, i}).start);
      }
    has_outlines_ = true;
    return memory_.part[part];
  }

  const PairShape<Predicates>& shape_;
  OverlapMemory& memory_;
  Axis least_;
  LengthBounds diameter_;
  bool has_bounds_ = false, has_outlines_ = false;
};

}  // namespace blocks::dynamics
