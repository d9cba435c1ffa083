// Which corners the edges of a block could act on before the next search (rule 13).
#pragma once

#include <algorithm>
#include <bit>
#include <compare>
#include <cstdint>
#include <vector>

#include "geometry/contact_predicates.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Of the list of potential contacts: corner, first corner of the edge.
struct Record {
  int corner, edge;
  auto operator<=>(const Record&) const = default;
};

/// A corner seen from an edge, for the question whether the edge could act on it before
/// two corners have gone `travel` towards each other: as far outside as `near`, or as
/// deep as rule 9 admits and that much more.
struct Reach {
  Vec2 origin, along;    ///< first corner; unit vector along the edge
  double length, depth;  ///< [L] of the edge; the most that rule 9 admits
  double near;  ///< [L] travel, the shield's reach, the slack of rules 10 and 12

  Reach(const Blocks& blocks, int b, int edge, double travel)
      : origin(blocks.corner.col(edge)) {
    const Vec2 e = Vec2(blocks.corner.col(blocks.next[edge])) - origin;
    length = e.norm();
    along = e / length;
    if (blocks.convex[b]) {
      depth = overlap(blocks.centroid.col(b));
    } else {
      depth = 0.0;
      for (int q = blocks.first_corner[b]; q < blocks.first_corner[b + 1]; ++q)
        depth = std::max(depth, 0.5 * overlap(blocks.corner.col(q)));
    }
    near = travel + geometry::contact_slack * length;
  }
  /// Overlap with the edge's line, [L].
  double overlap(const Vec2& c) const { return geometry::cross(c - origin, along); }
  /// In the strip of the edge, `near` beyond its ends (rule 10).
  bool between(const Vec2& c) const {
    const double s = (c - origin).dot(along);
    return s >= -near && s <= length + near;
  }
  /// Grows the box until it holds all that lies straight below the edge as deep as it
  /// may act: where sides cross, that is beyond the block.
  void extend(Vec2& lower, Vec2& upper) const {
    const Vec2 below = origin + depth * Vec2(along.y(), -along.x());
    for (const Vec2& end : {below, Vec2(below + length * along)})
      lower = lower.cwiseMin(end), upper = upper.cwiseMax(end);
  }
};

/// The edges of one block, and the box outside of which they act on nothing.
struct BlockReach {
  int first = 0;  ///< corner of the block
  bool convex = true;
  std::vector<Reach> edges;
  Vec2 lower, upper;  ///< [L] of the box

  /// Of block b, until corners have gone by the tolerance, [L].
  void set(const Blocks& blocks, int b, double tolerance);
  bool far(const Vec2& at) const {
    // nothing to guess: most corners that are asked about are far
    return ((at.x() < lower.x()) | (at.x() > upper.x()) | (at.y() < lower.y()) |
            (at.y() > upper.y())) != 0;
  }
  /// The edge after and the one before edge e.
  int after(int e) const { return e + 1 < static_cast<int>(edges.size()) ? e + 1 : 0; }
  int ahead(int e) const { return e > 0 ? e - 1 : static_cast<int>(edges.size()) - 1; }
  /// Adds those of its edges that could act on corner c, which is not far, in their
  /// order.
  void find(const Vec2& at, int c, std::vector<Record>& found) const;
};

inline void BlockReach::find(const Vec2& at, int c, std::vector<Record>& found) const {
  constexpr int most = 64;  // answers in a word: they follow no pattern
  const int count = static_cast<int>(edges.size());
  const std::size_t before = found.size();
  int outside = 0, side = 0;
  for (int begin = 0; begin < count; begin += most) {
    std::uint64_t out = 0, listed = 0;
    for (int k = 0; k < std::min(most, count - begin); ++k) {
      const Reach& reach = edges[begin + k];
      const double overlap = reach.overlap(at);
      const bool inside = overlap >= -reach.near;
      const bool deep = overlap > reach.depth + reach.near;
      out |= static_cast<std::uint64_t>(!inside) << k;
      listed |= static_cast<std::uint64_t>(inside & !deep) << k;
    }
    if (out != 0)
      outside += std::popcount(out), side = begin + std::countr_zero(out);
    if (convex && outside > 0)
      continue;
    for (; listed != 0; listed &= listed - 1)
      found.push_back({c, first + begin + std::countr_zero(listed)});
  }
  if (!convex || outside == 0)
    return;
  // outside of one edge is outside of the block: there is but a crossing of sides
  found.resize(before);
  const auto add = [&](int e) {
    if (const Reach& reach = edges[e];
        reach.overlap(at) <= reach.depth + reach.near && reach.between(at))
      found.push_back({c, first + e});
  };
  if (outside == 1) {
    add(std::min(after(side), ahead(side)));
    add(std::max(after(side), ahead(side)));
  }
}

}  // namespace blocks::dynamics
