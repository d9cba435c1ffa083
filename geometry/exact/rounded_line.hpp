// PRIVATE to geometry/: rounds exact points on a line of an outline to doubles, towards
// one side of the line.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/exact/binary_unit.hpp"
#include "geometry/exact/numbers.hpp"

namespace blocks::geometry::exact {

/// One coordinate of points on a line, rounded once for each point.
class RoundedCoordinate {
 public:
  /// side: direction in which coordinates are rounded, as in rounded_towards.
  RoundedCoordinate(const Rational& from, const Rational& to, int side)
      : unit_(common_denominator({from, to})), from_(times(from, unit_)),
        length_(times(to, unit_) - from_), side_(side) {}
  /// Likewise between doubles, in fewer steps.
  RoundedCoordinate(double from, double to, int side) : side_(side) {
    BinaryUnit unit;
    unit.see(from);
    unit.see(to);
    const Fraction start = unit.times_unit(unit(from), 1);
    from_ = start.num;
    unit_ = start.den;
    length_ = unit.times_unit(unit(to), 1).num - from_;
  }
  double at(const Fraction& s) const {
    return rounded_place(from_, length_, unit_, s, side_);
  }

 private:
  Integer unit_, from_, length_;
  int side_;
};

/// Points on a line that has the layer or the block on its left. The two ends are the
/// given doubles. Points on an axis-parallel line are rounded to the nearest doubles,
/// which other layers and blocks share. Between the ends of a slanted line each
/// coordinate is rounded towards the left. So no vertex is behind the line through the
/// rounded ends or behind the exact line. Layers that share the whole line therefore
/// never overlap.
class RoundedLine {
 public:
  /// from, to: exact ends [L]; start, end: the same ends as doubles [L].
  RoundedLine(const Point& from, const Point& to, const Vec2& start, const Vec2& end)
      : start_(start), end_(end) {
    const int rises = CGAL::sign(to.y() - from.y()),
              runs = CGAL::sign(to.x() - from.x());
    const bool slanted = rises != 0 && runs != 0;
    x_side_ = slanted ? -rises : 0;
    y_side_ = slanted ? runs : 0;
    add(from, to);
    const Point first(start_.x(), start_.y()), last(end_.x(), end_.y());
    if (slanted && (first != from || last != to))
      add(first, last);
  }
  /// Likewise for a line whose ends are doubles.
  RoundedLine(const Vec2& start, const Vec2& end) : start_(start), end_(end) {
    const bool slanted = start.x() != end.x() && start.y() != end.y();
    x_side_ = !slanted ? 0 : start.y() < end.y() ? -1 : 1;
    y_side_ = !slanted ? 0 : start.x() < end.x() ? 1 : -1;
    x_.emplace_back(start.x(), end.x(), x_side_);
    y_.emplace_back(start.y(), end.y(), y_side_);
  }
  /// Returns the rounded point at fraction s of the line, 0 <= s <= 1.
  Vec2 at(const Fraction& s) const {
    if (s.num == 0)
      return start_;
    if (s.num == s.den)
      return end_;
    Vec2 place(x_[0].at(s), y_[0].at(s));
    if (x_.size() > 1)
      place = {inner(place.x(), x_[1].at(s), x_side_),
               inner(place.y(), y_[1].at(s), y_side_)};
    return place;
  }

 private:
  void add(const Point& from, const Point& to) {
    x_.emplace_back(from.x(), to.x(), x_side_);
    y_.emplace_back(from.y(), to.y(), y_side_);
  }
  static double inner(double a, double b, int side) {
    return side < 0 ? std::min(a, b) : std::max(a, b);
  }

  Vec2 start_, end_;
  int x_side_, y_side_;
  std::vector<RoundedCoordinate> x_, y_;  ///< of the exact line and of the rounded one
};

}  // namespace blocks::geometry::exact
