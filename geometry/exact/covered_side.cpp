// The exact test is a template over the number type. It runs with intervals first, and
// with rationals if an interval cannot decide.
#include "geometry/covered_side.hpp"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <optional>
#include <type_traits>

#include "geometry/exact/sides.hpp"

namespace blocks::geometry {
namespace {

using exact::Rational;
using sides::Interval;
using sides::least;
using sides::most;
using sides::Overflow;
using sides::Part;
using sides::range;
using sides::Vector;

thread_local unsigned long long undecided_by_intervals = 0;

/// Decides for one side end, with one number type.
template <class Number> class Question {
 public:
  Question(const SideEnd& end, Outline other)
      : own_(end.polygon), other_(other), at_start_(end.at_start), side_(end.side),
        first_(at(own_, side_)), along_(edge(own_, side_)),
        square_(dot(along_, along_)) {}

  /// Returns nothing if the number type is not precise enough to decide.
  std::optional<Cover> answer(std::span<const Outline> neighbours) const {
    const Part<Number> interval = part_in(own_, side_, other_);
    if (interval.is_empty())
      return Cover{};
    const Part<Number> stretch = at_start_ ? Part<Number>{Number(0), interval.to}
                                           : Part<Number>{interval.from, Number(1)};
    Number of_stretch(0), of_interval(0), longest(0);
    Cover found;
    bool rivals = false;  // it is uncertain which side covers most
    for (int k = 0; k < static_cast<int>(neighbours.size()); ++k)
      for (int f = 0; f < static_cast<int>(neighbours[k].size()); ++f) {
        const Part<Number> covered = covered_by(neighbours[k], f, stretch);
        if (covered.is_empty())
          continue;
        const Number length = most(Number(0), covered.length());
        of_stretch += length;
        of_interval += most(Number(0), covered.common(interval).length());
        if (!found || CGAL::certainly(length > longest)) {
          rivals = false, longest = length, found = {k, f};
        } else if (CGAL::possibly(length > longest)) {
          // A later side must be longer than both before it is certainly the longest.
          rivals = true, longest = most(longest, length);
        }
      }
    const auto enough = of_stretch >= Number(covered_share) * stretch.length(),
               inside = of_interval >= Number(covered_share) * interval.length();
    if (!found || CGAL::certainly(!enough) || CGAL::certainly(!inside))
      return Cover{};
    if (rivals || interval.may_be_empty() || CGAL::possibly(!enough) ||
        CGAL::possibly(!inside))
      return std::nullopt;
    return found;
  }

 private:
  static const Vec2& at(Outline polygon, int corner) {
    return sides::start_of(polygon, corner);
  }
  static const Vec2& end(Outline polygon, int side) {
    return sides::end_of(polygon, side);
  }
  Vector<Number> edge(Outline polygon, int side) const {
    return between(at(polygon, side), end(polygon, side));
  }
  Vector<Number> between(const Vec2& from, const Vec2& to) const { return {from, to}; }

  static Part<Number> part_in(Outline polygon, int side, Outline other) {
    return sides::part_in<Number>(polygon, side, other);
  }

  /// Returns the part of the stretch that side f of a neighbour covers.
  Part<Number> covered_by(Outline neighbour, int f, const Part<Number>& stretch) const {
    const Part<Number> none{Number(1), Number(0)};
    const Vector<Number> across = edge(neighbour, f);
    if (CGAL::certainly(dot(along_, across) >= 0))
      return none;
    const Vec2 &near = end(neighbour, f), &far = at(neighbour, f);
    const Vector<Number> to_near = between(first_, near), to_far = between(first_, far);
    const Number from = dot(to_near, along_) / square_,
                 to = dot(to_far, along_) / square_;
    const Part<Number> covered = stretch.common({from, to});
    if (covered.is_empty())
      return none;
    const auto faces = face(across);
    if (CGAL::certainly(!faces))
      return none;
    // From here on, lengths are in units of the tested side.
    const Number h = stretch.length();
    const auto reaches = reaches_below(neighbour, f, h);
    if (CGAL::certainly(!reaches))
      return none;
    const Number gap_from = cross(along_, to_near) / square_,
                 gap_to = cross(along_, to_far) / square_;
    const Number middle = (covered.from + covered.to) / Number(2);
    const Number gap = gap_from + (gap_to - gap_from) * (middle - from) / (to - from);
    if (CGAL::certainly(gap > h))
      return none;
    const Part<Number> inside = part_in(neighbour, f, other_);
    const auto overlap = (gap <= 0) & (-gap <= h);
    if (inside.is_empty() && CGAL::certainly(!overlap))
      return none;
    const auto touches = touch_along(neighbour, f);
    if (CGAL::certainly(!touches))
      return none;
    const bool sure = CGAL::certainly(faces) && CGAL::certainly(reaches) &&
                      CGAL::certainly(gap <= h) && CGAL::certainly(touches) &&
                      (!inside.may_be_empty() || CGAL::certainly(overlap));
    if constexpr (std::is_same_v<Number, Interval>)
      if (!sure)  // the part may be empty
        return {covered.from, range(covered.from, covered.to)};
    return covered;
  }

  /// Tests whether two sides with opposite directions are within ten degrees of
  /// antiparallel.
  auto face(const Vector<Number>& across) const {
    const Number sine = cross(along_, across), a = sine * sine;
    const Number q = square_ * dot(across, across);
    return (Number(4) * a < q) &
           (a * (Number(64) * a * a - Number(96) * a * q + Number(36) * q * q) <=
            q * q * q);
  }

  /// Tests whether `other` reaches at least h below side f.
  auto reaches_below(Outline neighbour, int f, const Number& h) const {
    const Vector<Number> across = edge(neighbour, f);
    const Number deepest_area = deepest(neighbour, f, other_);
    return (deepest_area >= 0) &
           (deepest_area * deepest_area >= h * h * square_ * dot(across, across));
  }

  /// Returns twice the area of the triangle of a side and the other polygon's deepest
  /// corner below it.
  Number deepest(Outline polygon, int side, Outline other) const {
    const Vector<Number> along = edge(polygon, side);
    const auto area = [&](const Vec2& corner) {
      return cross(between(at(polygon, side), corner), along);
    };
    Number found = area(other.front());
    for (const Vec2& corner : other.subspan(1))
      found = most(found, area(corner));
    return found;
  }
  /// Returns the signed square x |x| of a depth x.
  Number depth(Outline polygon, int side, Outline other) const {
    const Vector<Number> along = edge(polygon, side);
    const Number area = deepest(polygon, side, other);
    return area * CGAL::abs(area) / dot(along, along);
  }
  /// Tests that no other side of the own polygon or the neighbour is less deep than
  /// both of these two.
  auto touch_along(Outline neighbour, int f) const {
    const Number along =
        least(depth(own_, side_, neighbour), depth(neighbour, f, own_));
    decltype(along < along) less_deep = false;
    for (int e = 0; e < static_cast<int>(own_.size()); ++e)
      if (e != side_)
        less_deep = less_deep | (depth(own_, e, neighbour) < along);
    for (int e = 0; e < static_cast<int>(neighbour.size()); ++e)
      if (e != f)
        less_deep = less_deep | (depth(neighbour, e, own_) < along);
    return !less_deep;
  }

  Outline own_, other_;
  bool at_start_;
  int side_;
  Vec2 first_;
  Vector<Number> along_;
  Number square_;
};

/// Returns nothing if the intervals cannot decide.
std::optional<Cover> answer_by_intervals(const SideEnd& end, Outline other,
                                         std::span<const Outline> neighbours) {
  const Interval::Protector upward;
  try {
    return Question<Interval>(end, other).answer(neighbours);
  } catch (const Overflow&) {
    return std::nullopt;
  }
}

}  // namespace

unsigned long long exact::covering_calls() { return undecided_by_intervals; }

Cover find_cover(const SideEnd& end, Outline other,
                 std::span<const Outline> neighbours) {
  if (const auto sure = answer_by_intervals(end, other, neighbours))
    return *sure;
  ++undecided_by_intervals;
  return *Question<Rational>(end, other).answer(neighbours);
}

}  // namespace blocks::geometry
