#include "tests/audit/fault_of_parts.hpp"

#include <algorithm>
#include <map>

#include "audit/whole_numbers.hpp"

namespace blocks::audit {
namespace {

using Edge = std::pair<int, int>;

/// Returns whether every corner of the part is inside or on every side, and no corner
/// appears twice.
bool is_convex(const std::vector<Point>& corner, const std::vector<int>& part) {
  const std::size_t n = part.size();
  Whole area2 = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point &p = corner[part[i]], &q = corner[part[(i + 1) % n]];
    area2 += cross(q, p);
    for (std::size_t j = 0; j < n; ++j)
      if (sign(cross(corner[part[j]] - p, q - p)) < 0 || (i != j && part[i] == part[j]))
        return false;
  }
  return n >= 3 && area2 > 0;
}

/// Returns whether the directed edges cancel at every point: as many run forwards as
/// backwards.
bool cancel(const std::vector<Point>& corner, const std::map<Edge, int>& edges) {
  std::vector<Edge> left;
  for (const auto& [edge, count] : edges)
    for (int k = 0; k < std::abs(count); ++k)
      left.push_back(count > 0 ? edge : Edge(edge.second, edge.first));
  for (const Edge& line : left) {
    const Point& from = corner[line.first];
    const Point along = corner[line.second] - from;
    std::vector<std::pair<Whole, int>> changes;  // position along the line, direction
    for (const auto& [start, end] : left) {
      const Point p = corner[start] - from, q = corner[end] - from;
      if (sign(cross(p, along)) != 0 || sign(cross(q, along)) != 0)
        continue;
      const int way = dot(p, along) < dot(q, along) ? 1 : -1;
      changes.emplace_back(std::min(dot(p, along), dot(q, along)), way);
      changes.emplace_back(std::max(dot(p, along), dot(q, along)), -way);
    }
    std::sort(changes.begin(), changes.end());
    int sum = 0;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      sum += changes[i].second;
      const bool last =
          i + 1 == changes.size() || changes[i + 1].first > changes[i].first;
      if (last && sum != 0)
        return false;
    }
  }
  return true;
}

}  // namespace

/// This is the proof: the borders of all parts add up to the border of the block. So
/// each point inside the block is in one part, and each point outside is in none.
std::string fault_of_parts(const Blocks& blocks, int block,
                           const std::vector<ConvexPart>& parts) {
  Lattice lattice;
  const int first = blocks.first_corner[block], end = blocks.first_corner[block + 1];
  std::vector<Point> corner;
  corner.reserve(static_cast<std::size_t>(blocks.corners()));
  for (const double x : blocks.corner.reshaped())
    lattice.include(x);
  for (int c = 0; c < blocks.corners(); ++c)
    corner.push_back(lattice(Vec2(blocks.corner.col(c))));

  std::map<Edge, int> edges;  // the sides of the parts less the edges of the block
  const auto add = [&](int start, int stop, int count) {
    if (start < stop)
      edges[{start, stop}] += count;
    else
      edges[{stop, start}] -= count;
  };
  for (const ConvexPart& part : parts) {
    if (part.block != block)
      continue;
    for (const int c : part.corners)
      if (c < first || c >= end)
        return "A part has a corner of another block.";
    if (!is_convex(corner, part.corners))
      return "A part is not convex.";
    for (std::size_t i = 0; i < part.corners.size(); ++i)
      add(part.corners[i], part.corners[(i + 1) % part.corners.size()], 1);
  }
  for (int c = first; c < end; ++c)
    add(c, blocks.next[c], -1);
  if (!cancel(corner, edges))
    return "The parts overlap or leave a part of the block out.";
  return {};
}

}  // namespace blocks::audit
