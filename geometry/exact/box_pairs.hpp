// PRIVATE to geometry/: finds pairs of outlines whose bounding boxes intersect, in O(n
// log n) time. It uses the streamed segment tree of Zomorodian and Edelsbrunner, in
// CGAL.
#pragma once

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <cstddef>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::geometry::exact {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;

/// Returns the bounding box of a non-empty outline, enlarged by `reach` [L] on all
/// sides.
inline Box box_of(const Polygon& outline, std::size_t number, double reach = 0.0) {
  Vec2 low = outline.front();
  Vec2 high = outline.front();
  for (const Vec2& corner : outline) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  low.array() -= reach;
  high.array() += reach;
  double lower[2] = {low.x(), low.y()};
  double upper[2] = {high.x(), high.y()};
  return {lower, upper, number};
}

/// Calls visit(i, j), i < j, once for every two outlines whose boxes, each enlarged by
/// its reach, share a point. If `reach` is empty, the boxes must share an interior
/// point.
template <typename Visit>
void for_each_close_pair(const std::vector<Polygon>& outlines,
                         const std::vector<double>& reach, Visit visit) {
  std::vector<Box> boxes;
  boxes.reserve(outlines.size());
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (!outlines[i].empty())
      boxes.push_back(box_of(outlines[i], i, reach.empty() ? 0.0 : reach[i]));
  CGAL::box_self_intersection_d(
      boxes.begin(), boxes.end(),
      [&](const Box& a, const Box& b) {
        visit(std::min(a.info(), b.info()), std::max(a.info(), b.info()));
      },
      std::ptrdiff_t{10},
      reach.empty() ? CGAL::Box_intersection_d::HALF_OPEN
                    : CGAL::Box_intersection_d::CLOSED);
}

}  // namespace blocks::geometry::exact
