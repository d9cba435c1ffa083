#include "geometry/joints.hpp"

#include <CGAL/Mpzf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

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
  if (corner == a || corner == b)
    return 0.0;  // common corners are frequent, and need no exact numbers
  if (CGAL::orientation(exact::point(a), exact::point(b), exact::point(corner)) !=
      CGAL::LEFT_TURN)
    return 0.0;
  using Exact = CGAL::Mpzf;  // sums and products of doubles, without allocation
  const auto run = [&](const Vec2& to) { return Exact(to.x()) - Exact(a.x()); };
  const auto rise = [&](const Vec2& to) { return Exact(to.y()) - Exact(a.y()); };
  const Exact area = run(b) * rise(corner) - rise(b) * run(corner);
  return exact::nearest(exact::Rational(area)) / (b - a).stableNorm();
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
  if (edge.dot(d - c) >= 0.0)
    return;  // both are clockwise, so facing edges have opposite directions
  const double length = edge.stableNorm();
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
void drop_filled(const std::vector<Polygon>& outlines, std::vector<Opening>& openings,
                 StepProgress& progress) {
  std::vector<exact::Box> points, boxes;
  std::vector<int> filled(openings.size(), 0);
  for (std::size_t k = 0; k < openings.size(); ++k)
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
        progress.count(1, 1);
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

/// Close pairs for each block, about; progress is shown by it.
constexpr std::size_t usual_neighbours = 5;

/// What is known of a block before it is compared with others.
struct Extent {
  Eigen::AlignedBox2d box;  ///< [L]
  double rounding;          ///< [L] largest distance of a corner inside an edge
  double reach;             ///< [L] largest width of a slit
};

Extent extent_of(const Polygon& outline) {
  Extent extent;
  for (const Vec2& corner : outline)
    extent.box.extend(corner);
  extent.rounding = rounding_units * coarsest_ulp(outline);
  extent.reach = widest_slit * std::sqrt(std::abs(section_properties(outline).area));
  return extent;
}

/// Whether two boxes are at most so far apart, in both axes.
bool are_near(const Eigen::AlignedBox2d& a, const Eigen::AlignedBox2d& b,
              double distance) {
  return ((a.min() - b.max()).array() <= distance).all() &&
         ((b.min() - a.max()).array() <= distance).all();
}

Eigen::AlignedBox2d box_of_edge(const Polygon& outline, std::size_t edge) {
  const Vec2 &a = outline[edge],
             &b = outline[edge + 1 == outline.size() ? 0 : edge + 1];
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

/// Lists the edges of the outline that are near the box, with their boxes.
void list_near_edges(const Polygon& outline, const Eigen::AlignedBox2d& box,
                     double distance,
                     std::vector<std::pair<std::size_t, Eigen::AlignedBox2d>>& list) {
  list.clear();
  for (std::size_t k = 0; k < outline.size(); ++k)
    if (const auto edge = box_of_edge(outline, k); are_near(edge, box, distance))
      list.emplace_back(k, edge);
}

/// Finds the widest slit between two blocks; its width is 0 if there is none.
Opening widest_opening(const Polygon& p, const Extent& at_p, const Polygon& q,
                       const Extent& at_q) {
  Opening opening;
  const double reach = std::min(at_p.reach, at_q.reach);
  // Edges that are farther apart have no slit. The second term is far above the
  // rounding of distances from the lines of edges.
  const double apart =
      reach + 1e-10 * (at_p.box.sizes().sum() + at_q.box.sizes().sum());
  static thread_local std::vector<std::pair<std::size_t, Eigen::AlignedBox2d>> edges,
      others;
  list_near_edges(p, at_q.box, apart, edges);
  list_near_edges(q, at_p.box, apart, others);
  for (const auto& [k, box] : edges)
    for (const auto& [l, other] : others)
      if (are_near(box, other, apart))
        widen(p[k], p[(k + 1) % p.size()], q[l], q[(l + 1) % q.size()], reach, opening);
  return opening;
}

}  // namespace

Joints find_joints(const std::vector<Polygon>& outlines, StepProgress* progress) {
  const ProgressFunction none;
  StepProgress unseen(none, "");
  StepProgress& seen = progress ? *progress : unseen;
  std::vector<Extent> extents;
  std::vector<double> reach;
  extents.reserve(outlines.size());
  reach.reserve(outlines.size());
  for (const Polygon& outline : outlines) {
    seen.count(0, 1);
    extents.push_back(extent_of(outline));
    reach.push_back(extents.back().reach);
  }
  Joints joints;
  std::vector<Opening> openings;
  const auto corners_of = [&](std::size_t from, std::size_t to) {
    const double rounding = extents[to].rounding;
    Eigen::AlignedBox2d box = extents[to].box;
    box.min().array() -= rounding;
    box.max().array() += rounding;
    for (std::size_t c = 0; c < outlines[from].size(); ++c) {
      const Vec2& corner = outlines[from][c];
      if (box.contains(corner) && is_inside_an_edge(corner, outlines[to], rounding))
        joints.t_junctions.push_back({static_cast<int>(from), static_cast<int>(c),
                                      static_cast<int>(to), corner});
    }
  };
  std::size_t pairs = 0;
  exact::for_each_close_pair(
      outlines, reach,
      [&](std::size_t i, std::size_t j) {
        seen.count(++pairs, usual_neighbours * outlines.size());
        corners_of(i, j);
        corners_of(j, i);
        Opening opening =
            widest_opening(outlines[i], extents[i], outlines[j], extents[j]);
        Slit& slit = opening.slit;
        if (slit.width == 0.0)
          return;
        slit.first = static_cast<int>(i);
        slit.second = static_cast<int>(j);
        slit.by_rounding =
            slit.width <= std::max(extents[i].rounding, extents[j].rounding);
        if (slit.by_rounding)
          joints.slits.push_back(slit);
        else
          openings.push_back(opening);
      },
      &seen);
  drop_filled(outlines, openings, seen);
  for (const Opening& opening : openings)
    joints.slits.push_back(opening.slit);
  const auto sort = [&seen](auto& list, auto key) {
    std::sort(list.begin(), list.end(), [&](const auto& a, const auto& b) {
      seen.count(1, 1);
      return key(a) < key(b);
    });
  };
  sort(joints.t_junctions,
       [](const TJunction& t) { return std::tuple(t.block, t.corner, t.other); });
  sort(joints.slits, [](const Slit& s) { return std::pair(s.first, s.second); });
  return joints;
}

}  // namespace blocks::geometry
