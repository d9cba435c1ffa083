#include "validation/geometry/cut_judge.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/geometry/area_judge.hpp"
#include "validation/geometry/exact_judge.hpp"

namespace blocks::validation {
namespace {

using geometry::CutRequest;
using geometry::CutResult;
using geometry::Polygon;
using geometry::Vec2;
using geometry::testing::Exact;

Polygon polygon(const CutResult& result, const std::vector<int>& loop) {
  Polygon places;
  for (const int v : loop)
    places.push_back(result.mesh.vertices[static_cast<std::size_t>(v)]);
  return places;
}

bool has_all_corners(const CutRequest& request, const CutResult& result) {
  const Polygon outline = polygon(result, result.mesh.outline);
  auto from = outline.begin();
  for (const auto& corner : request.outline) {
    from = std::find(from, outline.end(), Vec2(corner.x.value(), corner.y.value()));
    if (from == outline.end())
      return false;
  }
  return true;
}

Exact area(const Polygon& p) {  // positive if clockwise
  Exact twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    twice += Exact(b.x()) * Exact(a.y()) - Exact(a.x()) * Exact(b.y());
  }
  return twice / 2;
}

// Is the block a part of its cell?
bool is_within(const CutResult& result, std::size_t i) {
  const auto& corners = result.blocks[i].corners;
  const auto& cell = result.mesh.cells[i];
  if (corners == cell)
    return true;
  auto from = cell.begin();
  for (const int v : corners) {
    from = std::find(from, cell.end(), v);
    if (from == cell.end())
      return false;
  }
  const Polygon block = polygon(result, corners);
  geometry::Mesh alone;
  alone.vertices = block;
  for (int k = 0; k < static_cast<int>(block.size()); ++k)
    alone.outline.push_back(k);
  alone.cells = {alone.outline};
  return judge(alone).tiles &&
         geometry::testing::common_area(block, polygon(result, cell)) == area(block);
}

// Is the distance of p from the segment a-b at most `reach`? Segments may be so long
// that doubles cannot tell.
bool is_near(const Vec2& p, const Vec2& a, const Vec2& b, double reach) {
  const Exact dx = Exact(b.x()) - Exact(a.x()), dy = Exact(b.y()) - Exact(a.y());
  const Exact px = Exact(p.x()) - Exact(a.x()), py = Exact(p.y()) - Exact(a.y());
  const Exact square = dx * dx + dy * dy;
  Exact along = square > 0 ? Exact((px * dx + py * dy) / square) : Exact(0);
  along = std::clamp<Exact>(along, 0, 1);
  const Exact x = px - along * dx, y = py - along * dy;
  return x * x + y * y <= Exact(reach) * Exact(reach);
}

bool ids_are_near(const CutRequest& request, const CutResult& result) {
  double largest = 0.0;
  for (const Vec2& v : result.mesh.vertices)
    largest = std::max(largest, v.lpNorm<Eigen::Infinity>());
  // A T vertex moves by 64 units, a few times at most; rounding is one unit.
  const double reach = 1024.0 * 0x1p-52 * largest;
  for (const auto& block : result.blocks)
    for (std::size_t i = 0; i < block.corners.size(); ++i) {
      const int id = block.joints[i];
      const auto at = [&](std::size_t k) {
        const int v = block.corners[k % block.corners.size()];
        return result.mesh.vertices[static_cast<std::size_t>(v)];
      };
      const Vec2 a = at(i), b = at(i + 1), middle = (a + b) / 2.0;
      const auto is_on = [&](const auto& joint) {
        return joint.id == id &&
               is_near(middle, joint.from.nearest(), joint.to.nearest(), reach);
      };
      if (id != 0 && std::none_of(request.joints.begin(), request.joints.end(), is_on))
        return false;
    }
  return true;
}

}  // namespace

std::string judge_cut(const CutRequest& request, const CutResult& result) {
  const Judgement mesh = judge(result.mesh);
  if (!mesh.tiles || !mesh.conforming)
    return mesh.reason;
  if (!has_all_corners(request, result))
    return "a corner of the outline is missing";
  const std::size_t n = result.mesh.cells.size();
  if (result.blocks.size() != n || result.joints.size() != n)
    return "cells and blocks differ in number";
  for (std::size_t i = 0; i < n; ++i)
    if (result.joints[i].size() != result.mesh.cells[i].size() ||
        result.blocks[i].joints.size() != result.blocks[i].corners.size())
      return "a side has no joint id";
  for (std::size_t i = 0; i < n; ++i)
    if (!is_within(result, i))
      return "a block is not a part of its cell";
  if (result.report.contractions == 0 && !ids_are_near(request, result))
    return "a side has the id of a joint that is not there";
  return {};
}

}  // namespace blocks::validation
