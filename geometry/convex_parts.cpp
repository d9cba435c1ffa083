#include "geometry/convex_parts.hpp"

#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>

#include <algorithm>
#include <iterator>
#include <list>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/exact/kernels.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
std::vector<std::vector<int>> convex_parts(const Polygon& outline) {
  const OutlineCheck check = check_outline(outline);
  if (check.fault != OutlineFault::none)
    return {};
  std::vector<int> all(outline.size());
  std::iota(all.begin(), all.end(), 0);
  if (check.convex) {
    if (check.anticlockwise)
      std::reverse(all.begin(), all.end());
    return {all};
  }
  using Traits = CGAL::Partition_traits_2<exact::Filtered>;
  std::vector<exact::Filtered::Point_2> points;  // anticlockwise, as CGAL requires
  std::map<std::pair<double, double>, int> number;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    points.push_back(exact::point(outline[i]));
    number[{outline[i].x(), outline[i].y()}] = static_cast<int>(i);
  }
  if (!check.anticlockwise)
    std::reverse(points.begin(), points.end());
  std::list<Traits::Polygon_2> pieces;
  CGAL::approx_convex_partition_2(points.begin(), points.end(),
                                  std::back_inserter(pieces), Traits());
  std::vector<std::vector<int>> parts;
  for (const auto& piece : pieces) {
    std::vector<int> part;
    for (const auto& corner : piece.container())
      part.push_back(number.at({corner.x(), corner.y()}));
    std::reverse(part.begin(), part.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace blocks::geometry
