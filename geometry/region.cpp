#include "geometry/region.hpp"

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/exact/kernels.hpp"

namespace blocks::geometry {
namespace {

using exact::Filtered;
using exact::Kernel;
using exact::Rational;

exact::Point rational(const Vec2& p) { return {Rational(p.x()), Rational(p.y())}; }

template <class Traits, class Point>
bool is_in_closed_region(const std::vector<Point>& outline, const Point& point) {
  return CGAL::bounded_side_2(outline.begin(), outline.end(), point, Traits()) !=
         CGAL::ON_UNBOUNDED_SIDE;
}

/// Adds the parameters, 0 to 1, at which the side from p along d meets the segment from
/// a to b. The two intersect.
void add_meetings(const exact::Point& p, const exact::Vector& d, const exact::Point& a,
                  const exact::Point& b, std::vector<Rational>& at) {
  const exact::Vector along = b - a;
  const Rational turn = exact::cross(d, along);
  if (turn != 0) {
    at.push_back(exact::cross(a - p, along) / turn);
    return;
  }
  for (const exact::Point& end : {a, b})
    if (const Rational s = (end - p) * d / d.squared_length(); s > 0 && s < 1)
      at.push_back(s);
}

}  // namespace

Region::Region(Polygon outline) : outline_(std::move(outline)) {
  for (const Vec2& corner : outline_)
    box_.extend(corner);
}

bool Region::contains(const Polygon& polygon) const {
  // A NaN is not inside the box.
  if (!std::all_of(polygon.begin(), polygon.end(),
                   [&](const Vec2& corner) { return box_.contains(corner); }))
    return false;
  // The outside of a simple outline is connected and unbounded. So it meets the inside
  // of the polygon only if it also meets its sides.
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (!contains_side(polygon[i], polygon[(i + 1) % polygon.size()]))
      return false;
  return true;
}

bool Region::contains(const Vec2& point) const {
  if (!box_.contains(point))
    return false;
  std::vector<Filtered::Point_2> corners;
  for (const Vec2& corner : outline_)
    corners.push_back(exact::point(corner));
  return is_in_closed_region<Filtered>(corners, exact::point(point));
}

/// Between two successive meetings with the outline, a side is inside or outside as a
/// whole. So the middle of each such part decides.
bool Region::contains_side(const Vec2& from, const Vec2& to) const {
  if (!contains(from))
    return false;
  const Filtered::Segment_2 side(exact::point(from), exact::point(to));
  const exact::Point p = rational(from);
  const exact::Vector d = rational(to) - p;
  std::vector<Rational> at;
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const Vec2 &a = outline_[i], &b = outline_[(i + 1) % outline_.size()];
    if (CGAL::do_intersect(side, Filtered::Segment_2(exact::point(a), exact::point(b))))
      add_meetings(p, d, rational(a), rational(b), at);
  }
  if (at.empty())
    return true;
  at.insert(at.end(), {Rational(0), Rational(1)});
  std::sort(at.begin(), at.end());
  std::vector<exact::Point> corners;
  for (const Vec2& corner : outline_)
    corners.push_back(rational(corner));
  for (std::size_t k = 1; k < at.size(); ++k)
    if (at[k] != at[k - 1] &&
        !is_in_closed_region<Kernel>(corners, p + (at[k - 1] + at[k]) / 2 * d))
      return false;
  return true;
}

}  // namespace blocks::geometry
