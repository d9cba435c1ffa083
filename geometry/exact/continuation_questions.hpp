// PRIVATE to geometry/: what a third polygon changes where two others overlap
// (docs/contact-rule.md), as templates over the number type. With quotients each answer
// is exact. With intervals a comparison that they cannot decide throws.
#pragma once

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "geometry/contact_constants.hpp"
#include "geometry/continuation.hpp"
#include "geometry/exact/sides.hpp"

namespace blocks::geometry::continuation {

using CGAL::square;
using sides::Interval;
using sides::max_of;
using sides::min_of;
using sides::Rational;

/// A vector, or a point as the vector from the origin of coordinates.
template <class Number> struct Arrow {
  Number x, y;
  Arrow(const Number& along_x, const Number& along_y) : x(along_x), y(along_y) {}
  explicit Arrow(const Vec2& point) : x(point.x()), y(point.y()) {}
  Arrow operator+(const Arrow& o) const { return {x + o.x, y + o.y}; }
  Arrow operator-(const Arrow& o) const { return {x - o.x, y - o.y}; }
  Arrow operator-() const { return {-x, -y}; }
  /// The vector turned by a right angle to the left: outwards from a clockwise side.
  Arrow left() const { return {-y, x}; }
};
template <class Number>
Arrow<Number> operator*(const Number& factor, const Arrow<Number>& a) {
  return {factor * a.x, factor * a.y};
}
template <class Number> Number cross(const Arrow<Number>& a, const Arrow<Number>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class Number> Number dot(const Arrow<Number>& a, const Arrow<Number>& b) {
  return a.x * b.x + a.y * b.y;
}

/// A side from its first corner, as a vector.
template <class Number> struct Side {
  Arrow<Number> start, end, along;
  Side(Outline polygon, int i)
      : Side(sides::start_of(polygon, i), sides::end_of(polygon, i)) {}
  Side(const Vec2& p1, const Vec2& p2) : start(p1), end(p2), along(end - start) {}
  /// Twice the area below the side: the depth of the point times the length.
  /// It is exactly 0 at both ends, also with intervals.
  Number area(const Arrow<Number>& point) const {
    const bool is_at_end =
        CGAL::certainly(point.x == end.x) && CGAL::certainly(point.y == end.y);
    return is_at_end ? Number(0) : cross(point - start, along);
  }
  Number length2() const { return dot(along, along); }
  /// The foot of a point, in lengths of the side from its start.
  Number foot(const Arrow<Number>& point) const {
    return dot(point - start, along) / length2();
  }
  /// The point at a foot. It is measured from the end beyond the middle, so that
  /// intervals have no width at either end.
  Arrow<Number> at(const Number& foot) const {
    return CGAL::certainly(foot > Number(0.5)) ? end - (Number(1) - foot) * along
                                               : start + foot * along;
  }
};

/// Calls visit(area, side, sign) for each axis of two polygons. The area is that of the
/// deepest corner of the one polygon below the side of the other. A shift v of the
/// moving polygon adds sign * (v x side) to it.
template <class Number, class Visit>
void each_axis(Outline moving, Outline resting, const Visit& visit) {
  const auto all = [&](Outline own, Outline other, int sign) {
    for (int i = 0; i < static_cast<int>(own.size()); ++i) {
      const Side<Number> side(own, i);
      Number deepest = side.area(Arrow<Number>(other.front()));
      for (const Vec2& corner : other.subspan(1))
        deepest = max_of(deepest, side.area(Arrow<Number>(corner)));
      visit(deepest, side, sign);
    }
  };
  all(resting, moving, 1);
  all(moving, resting, -1);
}

/// Returns the square of the shortest shift that separates two polygons, 0 if they are
/// separate.
template <class Number> Number separating_shift2(Outline one, Outline other) {
  std::optional<Number> found;
  each_axis<Number>(one, other, [&](const Number& area, const Side<Number>& side, int) {
    const Number inside = max_of(Number(0), area);
    const Number shift2 = square(inside) / side.length2();
    found = found ? min_of(*found, shift2) : shift2;
  });
  return *found;
}

/// The numbers u for which all of several sums `value + u gain` are not negative.
template <class Number> class Range {
 public:
  void cut(const Number& value, const Number& gain) {
    if (CGAL::certainly(gain > 0))
      raise(-value / gain);
    else if (CGAL::certainly(gain < 0))
      lower(-value / gain);
    else
      cut_by_either(value, gain);
  }
  const Number& from() const { return *from_; }
  const Number& to() const { return *to_; }
  void raise(const Number& limit) { from_ = from_ ? max_of(*from_, limit) : limit; }

 private:
  void lower(const Number& limit) { to_ = to_ ? min_of(*to_, limit) : limit; }
  /// The sign of the gain is not known, as for parallel lines, or the gain is 0.
  void cut_by_either(const Number& value, const Number& gain) {
    if constexpr (std::is_same_v<Number, Interval>) {
      if (!(value > 0))
        throw CGAL::Uncertain_conversion_exception("the range may be empty");
      const double largest = std::max(-gain.inf(), gain.sup());
      if (largest == 0.0)
        return;
      const Interval far = value / largest;
      const double infinite = std::numeric_limits<double>::infinity();
      raise({-infinite, -far.inf()}), lower({far.inf(), infinite});
    } else if (value < 0) {
      raise(Number(1)), lower(Number(0));
    }
  }

  std::optional<Number> from_, to_;
};

/// An axis, and what one third polygon means for it.
template <class Number> class AxisQuestion {
 public:
  explicit AxisQuestion(const PolygonAxis& axis)
      : axis_(axis), e_(axis.own, axis.side),
        corner_(axis.other[static_cast<std::size_t>(axis.corner)]),
        area_(e_.area(corner_)), length2_(e_.length2()), low_(e_.foot(corner_)),
        high_(low_) {
    if (axis.facing < 0)
      return;
    const Arrow<Number> a(sides::start_of(axis.other, axis.facing)),
        b(sides::end_of(axis.other, axis.facing));
    high_ = e_.foot(a), low_ = e_.foot(b);  // the sides run against each other
  }

  bool is_hidden_by(Outline third, Continues which) const {
    const Number shift2 = separating_shift2<Number>(moving(which), third);
    const std::optional<Range<Number>> slide = slide_along(third, which, shift2);
    if (!slide || !is_local(third, which, shift2))
      return false;
    const Number forward = slide->to(), backward = -slide->from();
    const Number max_way = Number(longest_way) * min_of(forward, backward);
    return (forward > max_way || Number(1) - low_ - forward < forward) &&
           (backward > max_way || high_ - backward < backward);
  }
  bool is_in_notch_of(Outline third) const {
    const Number before = -low_, after = low_ - Number(1);
    const bool is_before = before > 0;
    if (!is_before && !(after > 0))
      return false;
    const std::optional<Range<Number>> slide =
        slide_along(third, Continues::own,
                    separating_shift2<Number>(moving(Continues::own), third));
    if (!slide)
      return false;
    return is_before ? Number(2) * slide->to() >= before
                     : Number(-2) * slide->from() >= after;
  }

 private:
  Outline moving(Continues which) const {
    return which == Continues::own ? axis_.other : axis_.own;
  }
  /// Shifts one of the two polygons out of the other through the side of the axis. If
  /// the third polygon blocks that, because the two overlap by enough then, returns how
  /// far it may slide along the side until it leaves the third one. shift2: the present
  /// separating_shift2 of the two.
  std::optional<Range<Number>> slide_along(Outline third, Continues which,
                                           const Number& shift2) const {
    const Number sign(which == Continues::own ? 1 : -1);
    const Number depth = area_ / length2_;  // in lengths of the side
    const Arrow<Number> out = (sign * depth) * e_.along.left(), way = sign * e_.along;
    const Number enough2 =
        max_of(square(Number(remaining_share) * area_),
               square(Number(remaining_overlap)) * shift2 * length2_);
    Range<Number> range;
    bool overlap = true;
    each_axis<Number>(moving(which), third,
                      [&](const Number& area, const Side<Number>& side, int turn) {
                        const Number now = area + Number(turn) * cross(out, side.along);
                        // The signed square needs no sign of its own, which flush sides
                        // leave open.
                        overlap = overlap && now * CGAL::abs(now) * length2_ >=
                                                 enough2 * side.length2();
                        if (overlap)
                          range.cut(now, Number(turn) * cross(way, side.along));
                      });
    return overlap ? std::optional(range) : std::nullopt;
  }
  /// Returns whether the third polygon is at the contact point, within the width of a
  /// closed joint. shift2: as in slide_along.
  bool is_local(Outline third, Continues which, const Number& shift2) const {
    const Number depth2 = square(area_) / length2_;
    const Number width2 =
        min_of(square(Number(joint_width)) * max_of(depth2, shift2),
               square(Number(widest_joint)) *
                   min_of(longest_side2(axis_.own), longest_side2(axis_.other)));
    if (which == Continues::other && axis_.facing < 0)
      return is_within(corner_, third, width2);
    // The middle of what the two faces have in common, or the foot of the corner.
    const Number zero(0), one(1);
    const Number at =
        (max_of(zero, min_of(one, low_)) + max_of(zero, min_of(one, high_))) /
        Number(2);
    const Arrow<Number> middle = e_.at(at);
    if (which == Continues::own)
      return is_beyond(middle, e_.along.left(), third, width2);
    const Side<Number> f(axis_.other, axis_.facing);
    const Number on_f = (high_ - at) / (high_ - low_);
    return is_beyond(f.at(on_f), f.along.left(), third, width2);
  }
  /// Returns whether a point is at most a distance away from a polygon.
  static bool is_within(const Arrow<Number>& point, Outline polygon,
                        const Number& distance2) {
    bool is_inside = true;
    for (int i = 0; i < static_cast<int>(polygon.size()); ++i) {
      const Side<Number> side(polygon, i);
      const Number foot = max_of(Number(0), min_of(Number(1), side.foot(point)));
      const Arrow<Number> apart = point - side.at(foot);
      if (dot(apart, apart) <= distance2)
        return true;
    }
    for (int i = 0; i < static_cast<int>(polygon.size()) && is_inside; ++i)
      is_inside = Side<Number>(polygon, i).area(point) >= 0;
    return is_inside;
  }
  static Number longest_side2(Outline polygon) {
    Number found(0);
    for (int i = 0; i < static_cast<int>(polygon.size()); ++i)
      found = max_of(found, Side<Number>(polygon, i).length2());
    return found;
  }
  /// Returns whether a ray meets a polygon within a distance, given by its square.
  static bool is_beyond(const Arrow<Number>& start, const Arrow<Number>& way,
                        Outline polygon, const Number& distance2) {
    const Number way2 = dot(way, way);
    Range<Number> range;
    range.raise(Number(0));
    for (int i = 0; i < static_cast<int>(polygon.size()); ++i) {
      const Side<Number> side(polygon, i);
      const Number area = side.area(start), gain = cross(way, side.along);
      if (CGAL::certainly(area < 0) &&
          (CGAL::certainly(gain <= 0) ||
           CGAL::certainly(square(area) * way2 > square(gain) * distance2)))
        return false;  // this much of the ray is outside the side
      range.cut(area, gain);
    }
    return range.from() <= range.to() && square(range.from()) * way2 <= distance2;
  }

 public:
  /// Returns whether a point is outside each side by at most a distance.
  static bool is_near(const Arrow<Number>& point, Outline polygon,
                      const Number& distance2) {
    for (int i = 0; i < static_cast<int>(polygon.size()); ++i) {
      const Side<Number> side(polygon, i);
      const Number area = side.area(point);
      if (area * CGAL::abs(area) < -distance2 * side.length2())
        return false;
    }
    return true;
  }
  Number depth2() const { return square(max_of(Number(0), area_)) / length2_; }

 private:
  const PolygonAxis& axis_;
  Side<Number> e_;
  Arrow<Number> corner_;
  Number area_, length2_;
  Number low_, high_;  ///< feet of the facing side's end and start, or of the corner
};

/// Returns whether the foot of a corner is beyond an end of a side and close to a third
/// polygon, which does not contain the corner.
template <class Number>
bool is_at_joint(const Vec2& c, const Vec2& p1, const Vec2& p2,
                 const PolygonAxis& least_axis, Outline third) {
  const Side<Number> e(p1, p2);
  const Arrow<Number> corner(c);
  const Number foot = e.foot(corner);
  if (foot >= 0 && foot <= 1)
    return false;
  const auto excludes_corner = [&](int i) {
    return Side<Number>(third, i).area(corner) <= 0;
  };
  bool is_outside = false;
  for (int i = 0; i < static_cast<int>(third.size()) && !is_outside; ++i)
    is_outside = excludes_corner(i);
  return is_outside &&
         AxisQuestion<Number>::is_near(e.at(foot), third,
                                       AxisQuestion<Number>(least_axis).depth2());
}

/// Returns the square of the diameter of the common region of two polygons, 0 if there
/// is none.
template <class Number> Number diameter2(Outline one, Outline other) {
  std::vector<Arrow<Number>> vertices;
  const auto add = [&](Outline polygon, Outline in) {
    for (int i = 0; i < static_cast<int>(polygon.size()); ++i) {
      const auto segment = sides::part_in<Number>(polygon, i, in);
      if (!(segment.from < segment.to))
        continue;
      const Side<Number> side(polygon, i);
      vertices.push_back(side.start + segment.from * side.along);
      vertices.push_back(side.start + segment.to * side.along);
    }
  };
  add(one, other), add(other, one);
  Number found(0);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t k = i + 1; k < vertices.size(); ++k) {
      const Arrow<Number> apart = vertices[k] - vertices[i];
      found = max_of(found, dot(apart, apart));
    }
  return found;
}

/// Returns whether the depth of a corner below a side exceeds `deepest_share` times a
/// length, given by its square.
template <class Number>
bool exceeds(const Side<Number>& side, const Vec2& corner, const Number& length2) {
  const Number area = side.area(Arrow<Number>(corner));
  return area > 0 &&
         square(area) > square(Number(deepest_share)) * length2 * side.length2();
}

/// Returns whether a segment of a side, of positive length, lies in another polygon.
template <class Number> bool crosses(Outline polygon, int side, Outline other) {
  const auto segment = sides::part_in<Number>(polygon, side, other);
  return segment.from < segment.to;
}

template <class Number>
bool exceeds_common_region(const Vec2& c, const Vec2& p1, const Vec2& p2, Outline one,
                           Outline other) {
  const Number region2 = diameter2<Number>(one, other);
  return region2 > 0 && exceeds(Side<Number>(p1, p2), c, region2);
}

template <class Number>
bool exceeds_separating_shift(const Vec2& c, const Vec2& p1, const Vec2& p2,
                              Outline one, Outline other) {
  return exceeds(Side<Number>(p1, p2), c, separating_shift2<Number>(one, other));
}

}  // namespace blocks::geometry::continuation
