#include "geometry/joints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "geometry/corner_in_edge.hpp"
#include "geometry/exact/box_pairs.hpp"
#include "geometry/exact/kernels.hpp"
#include "geometry/exact/numbers.hpp"
#include "geometry/polygon.hpp"
#include "geometry/rounding.hpp"

namespace blocks::geometry {
namespace {

/// Returns how far outside the edge a -> b of a clockwise block the corner is, [L]; 0
/// on the edge's line or inside. The sign is exact, and the distance is exact up to
/// rounding.
double outside(const Vec2& a, const Vec2& b, const Vec2& corner) {
  if (CGAL::orientation(exact::point(a), exact::point(b), exact::point(corner)) !=
      CGAL::LEFT_TURN)
    return 0.0;
  const auto vector = [](const Vec2& from, const Vec2& to) {
    return exact::Vector(exact::Rational(to.x()) - exact::Rational(from.x()),
                         exact::Rational(to.y()) - exact::Rational(from.y()));
  };
  return exact::nearest(exact::cross(vector(a, b), vector(a, corner))) /
         (b - a).stableNorm();
}

/// A slit and three points inside it, distributed along its length.
struct Opening {
  Slit slit;
  std::array<Vec2, 3> middle;
};

/// Widens the opening to the gap between the edges a -> b and c -> d, if they face each
/// other. The gap is the larger of the distances at the two ends of their common
/// length; each end is a corner of one of them. It is 0 if the edges touch along their
/// common length or are more than `reach` apart.
void widen(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double reach,
           Opening& opening) {
  const Vec2 edge = b - a;
  const double length = edge.stableNorm();
  if (edge.dot(d - c) >= 0.0)
    return;  // both are clockwise, so facing edges have opposite directions
  const auto along = [&](const Vec2& p) { return edge.dot(p - a) / length; };
  const auto aside = [&](const Vec2& p) {
    return cross(edge, p - a) / length;
  };  // outwards
  const double from = along(d), to = along(c);
  const double low = std::max(from, 0.0), high = std::min(to, length);
  if (high - low <= reach)
    return;  // the edges share no more than a corner
  // An edge may be far away beyond the end of the other edge; only the common part
  // counts.
  const double slope = (aside(c) - aside(d)) / (to - from);
  const auto aside_at = [&](double place) { return aside(d) + slope * (place - from); };
  if (std::abs(aside_at(low)) > reach || std::abs(aside_at(high)) > reach)
    return;
  const Vec2& start = from > 0.0 ? d : a;
  const Vec2& end = to < length ? c : b;
  const double first = from > 0.0 ? outside(a, b, d) : outside(c, d, a);
  const double last = to < length ? outside(a, b, c) : outside(c, d, b);
  if (const double width = std::max(first, last); width > opening.slit.width) {
    opening.slit.width = width;
    opening.slit.place = first > last ? start : end;
    // The points avoid the lines of symmetry, where two blocks that fill the slit may
    // meet.
    constexpr std::array shares = {0.17, 0.44, 0.81};
    const Vec2 unit = edge / length, out(-unit.y(), unit.x());
    for (std::size_t i = 0; i < opening.middle.size(); ++i) {
      const double place = low + shares[i] * (high - low);
      opening.middle[i] = a + place * unit + 0.39 * aside_at(place) * out;
    }
  }
}

/// Tests whether the outline contains the point, by the crossing number in doubles.
bool holds(const Polygon& outline, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i] - point, b = outline[(i + 1) % outline.size()] - point;
    if ((a.y() > 0.0) != (b.y() > 0.0) && (cross(a, b) > 0.0) == (b.y() > a.y()))
      inside = !inside;
  }
  return inside;
}

/// Drops the openings that another block fills: blocks on the two sides of a sharp
/// wedge also have facing edges.
void drop_filled(const std::vector<Polygon>& outlines, std::vector<Opening>& openings) {
  std::vector<exact::Box> points, boxes;
  std::vector<int> filled(openings.size(), 0);
  for (std::size_t k = 0; k < openings.size(); ++k)
    if (!openings[k].slit.by_rounding)
      for (const Vec2& middle : openings[k].middle)
        points.push_back(exact::box_of({middle}, k));
  if (points.empty())
    return;
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (!outlines[i].empty())
      boxes.push_back(exact::box_of(outlines[i], i));
  CGAL::box_intersection_d(
      points.begin(), points.end(), boxes.begin(), boxes.end(),
      [&](const exact::Box& point, const exact::Box& box) {
        const Slit& slit = openings[point.info()].slit;
        const auto block = static_cast<int>(box.info());
        if (block != slit.first && block != slit.second &&
            holds(outlines[box.info()], {point.min_coord(0), point.min_coord(1)}))
          ++filled[point.info()];
      });
  std::size_t kept = 0;
  for (std::size_t k = 0; k < openings.size(); ++k)
    if (filled[k] < static_cast<int>(openings[k].middle.size()))
      openings[kept++] = openings[k];
  openings.resize(kept);
}

}  // namespace

Joints find_joints(const std::vector<Polygon>& outlines) {
  std::vector<double> reach;
  reach.reserve(outlines.size());
  for (const Polygon& outline : outlines)
    reach.push_back(widest_slit *
                    std::sqrt(std::abs(section_properties(outline).area)));
  Joints joints;
  std::vector<Opening> openings;
  const auto corners_of = [&](std::size_t from, std::size_t to) {
    const double rounding = rounding_units * coarsest_ulp(outlines[to]);
    const exact::Box box = exact::box_of(outlines[to], to, rounding);
    for (std::size_t c = 0; c < outlines[from].size(); ++c) {
      const Vec2& corner = outlines[from][c];
      if (box.min_coord(0) <= corner.x() && corner.x() <= box.max_coord(0) &&
          box.min_coord(1) <= corner.y() && corner.y() <= box.max_coord(1) &&
          is_inside_an_edge(corner, outlines[to], rounding))
        joints.t_junctions.push_back({static_cast<int>(from), static_cast<int>(c),
                                      static_cast<int>(to), corner});
    }
  };
  exact::for_each_close_pair(outlines, reach, [&](std::size_t i, std::size_t j) {
    corners_of(i, j);
    corners_of(j, i);
    const Polygon &p = outlines[i], &q = outlines[j];
    Opening opening{{static_cast<int>(i), static_cast<int>(j), 0.0, Vec2::Zero()}, {}};
    Slit& slit = opening.slit;
    for (std::size_t k = 0; k < p.size(); ++k)
      for (std::size_t l = 0; l < q.size(); ++l)
        widen(p[k], p[(k + 1) % p.size()], q[l], q[(l + 1) % q.size()],
              std::min(reach[i], reach[j]), opening);
    slit.by_rounding =
        slit.width <= rounding_units * std::max(coarsest_ulp(p), coarsest_ulp(q));
    if (slit.width > 0.0)
      openings.push_back(opening);
  });
  drop_filled(outlines, openings);
  for (const Opening& opening : openings)
    joints.slits.push_back(opening.slit);
  std::sort(joints.t_junctions.begin(), joints.t_junctions.end(),
            [](const TJunction& a, const TJunction& b) {
              return std::tie(a.block, a.corner, a.other) <
                     std::tie(b.block, b.corner, b.other);
            });
  std::sort(joints.slits.begin(), joints.slits.end(), [](const Slit& a, const Slit& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return joints;
}

}  // namespace blocks::geometry
