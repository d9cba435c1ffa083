#include "geometry/joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "geometry/exact/box_pairs.hpp"
#include "geometry/exact/kernels.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

bool in_box(const Vec2& a, const Vec2& b, const Vec2& corner) {
  return (a.cwiseMin(b).array() <= corner.array()).all() &&
         (corner.array() <= a.cwiseMax(b).array()).all();
}

double distance(const Vec2& a, const Vec2& b, const Vec2& corner) {
  const Vec2 edge = b - a;
  const Vec2 arm = corner - a;
  const double along = arm.dot(edge);
  const double squared = edge.squaredNorm();
  if (along <= 0.0)
    return arm.norm();
  if (along >= squared)
    return (corner - b).norm();
  return std::abs(cross(edge, arm)) / std::sqrt(squared);
}

/// How a corner stands to a block.
struct Standing {
  enum class Kind { away, at_corner, in_edge, near } kind = Kind::away;
  double width = 0.0;
};

Standing stand(const Vec2& corner, const Polygon& block, double reach) {
  Standing standing;
  double least = std::numeric_limits<double>::infinity();
  bool outside = true;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const Vec2& a = block[i];
    const Vec2& b = block[(i + 1) % block.size()];
    if (corner == a || corner == b)
      return {Standing::Kind::at_corner, 0.0};
    const double d = distance(a, b, corner);
    if (d > reach)
      continue;
    const auto turn =
        CGAL::orientation(exact::point(a), exact::point(b), exact::point(corner));
    if (turn == CGAL::COLLINEAR && in_box(a, b, corner))
      return {Standing::Kind::in_edge, 0.0};
    if (d < least) {
      least = d;
      outside = turn == CGAL::LEFT_TURN;
    }
  }
  // Inside, it is an overlap: another report's matter.
  if (least <= reach && outside)
    standing = {Standing::Kind::near, least};
  return standing;
}

}  // namespace

Joints find_joints(const std::vector<Polygon>& outlines) {
  std::vector<double> reach;
  reach.reserve(outlines.size());
  for (const Polygon& outline : outlines)
    reach.push_back(widest_slit *
                    std::sqrt(std::abs(section_properties(outline).area)));
  Joints joints;
  const auto look = [&](std::size_t from, std::size_t to, double within, Slit& slit) {
    const exact::Box box = exact::box_of(outlines[to], to, within);
    for (std::size_t c = 0; c < outlines[from].size(); ++c) {
      const Vec2& corner = outlines[from][c];
      if (corner.x() < box.min_coord(0) || corner.x() > box.max_coord(0) ||
          corner.y() < box.min_coord(1) || corner.y() > box.max_coord(1))
        continue;
      const Standing standing = stand(corner, outlines[to], within);
      if (standing.kind == Standing::Kind::in_edge)
        joints.t_junctions.push_back({static_cast<int>(from), static_cast<int>(c),
                                      static_cast<int>(to), corner});
      if (standing.kind == Standing::Kind::near && standing.width > slit.width) {
        slit.width = standing.width;
        slit.place = corner;
      }
    }
  };
  exact::for_each_close_pair(outlines, reach, [&](std::size_t i, std::size_t j) {
    const double within = std::min(reach[i], reach[j]);
    Slit slit{static_cast<int>(i), static_cast<int>(j), 0.0, Vec2::Zero()};
    look(i, j, within, slit);
    look(j, i, within, slit);
    if (slit.width > 0.0)
      joints.slits.push_back(slit);
  });
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
