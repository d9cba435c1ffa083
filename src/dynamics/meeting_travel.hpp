// For how long an edge keeps coming through to a corner inside it: it stays the nearest
// of its block, or keeps meeting that of the corner (ContactDecision::comes_through).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dynamics/edge_travel.hpp"

namespace blocks::dynamics {

/// Corner c is inside an edge p1 -> p2 of unit vector t and, up to the slack, inside
/// the edge g beside it at the nearer end, p2 say: c = p2 - a t + b g with b > 0, and
/// a >= 0 up to the slack. A side of c's block ends in c, its outward normal is n. If
/// n.g > 0 and a is less than the length L of the edge, the edge does not lie wholly
/// outside of that side: n.(p2 - c) = a n.t - b n.g > 0 only for n.t > 0, and then
/// n.(p1 - c) = (a - L) n.t - b n.g < 0. With a < 0 it does not by more than the slack
/// of g times |n.t| / sin(t, g): not more than that of the side, if that is so much
/// longer. Travel for which all this is sure: each vector keeps nine tenths of its
/// length, and its direction to a ninth of sin(t, g).
inline double not_beyond_travel(const Blocks& blocks, int c, int edge, int side) {
  const auto at = [&](int corner) { return Vec2(blocks.corner.col(corner)); };
  const int end = blocks.next[edge];
  const Vec2 along = at(end) - at(edge), own = at(blocks.next[side]) - at(side);
  const bool at_end =
      (at(c) - at(end)).squaredNorm() < (at(c) - at(edge)).squaredNorm();
  const Vec2 vertex = at(at_end ? end : edge);
  const Vec2 beside = at(at_end ? blocks.next[end] : blocks.previous[edge]) - vertex;
  const double length = along.norm(), own_length = own.norm(), other = beside.norm();
  const double sine = std::abs(geometry::cross(along, beside)) / (length * other);
  const double along_normal = std::abs(geometry::cross(along, own)) / length;
  const bool sure = geometry::cross(own, beside) > 0.25 * own_length * other &&
                    along_normal * other < 0.3 * sine * own_length * own_length &&
                    (at(c) - vertex).norm() < 0.5 * sine * length;
  return sure ? 0.1 * sine * std::min(1.0, own_length / other) *
                    std::min({length, own_length, other})
              : 0.0;
}

/// The edge keeps meeting a block (ContactDecision::meets), or nearly, for as long as
/// its corner c is inside the edge; asked of convex ones.
inline double meeting_travel(const Blocks& blocks, int c, int edge, int block,
                             bool nearly) {
  if (!blocks.convex[block])
    return 0.0;
  const auto inside = [&](int corner, int side) {
    return side_travel(blocks, corner, side, nearly);
  };
  const auto outside = [&](int corner, int side) {
    const EdgeView view(blocks, corner, side);
    return sign_travel((nearly ? view.slack() : 0.0) - view.overlap_product(),
                       view.length, view.distance);
  };
  double cut = 0.0, not_beyond_any = std::numeric_limits<double>::max();
  for (int q = blocks.first_corner[block]; q < blocks.first_corner[block + 1]; ++q) {
    cut = std::max(cut, outside(q, edge));
    double not_beyond = std::max(inside(edge, q), inside(blocks.next[edge], q));
    if (nearly && (q == c || blocks.next[q] == c))
      not_beyond = std::max(not_beyond, not_beyond_travel(blocks, c, edge, q));
    not_beyond_any = std::min(not_beyond_any, not_beyond);
  }
  return std::min(cut, not_beyond_any);
}

/// The edge meets the block of corner c, or nearly, as long as c is inside of it: a
/// side of that block that ends in c crosses the edge, or all of them are asked, for
/// `enough`.
inline double meeting_inside_travel(const Blocks& blocks, int c, int edge, bool nearly,
                                    double enough) {
  const auto inside = [&](int corner, int side) {
    return side_travel(blocks, corner, side, false);
  };
  double travel = 0.0;
  for (const auto& [side, far] :
       {std::pair(c, blocks.next[c]), {blocks.previous[c], blocks.previous[c]}}) {
    const double out = -inside(far, edge);
    if (out <= travel)
      continue;
    const double first = inside(edge, side), second = inside(blocks.next[edge], side);
    if ((first < 0.0) != (second < 0.0))
      travel = std::max(travel, std::min({out, std::abs(first), std::abs(second)}));
  }
  return travel >= enough
             ? travel
             : std::max(travel, meeting_travel(blocks, c, edge, blocks.corner_block[c],
                                               nearly));
}

/// Edge e stays the nearest of its block.
inline double nearest_travel(const Blocks& blocks, int c, int e) {
  const EdgeView q(blocks, c, e);
  const int block = blocks.corner_block[e];
  double travel = std::numeric_limits<double>::max();
  for (int f = blocks.first_corner[block]; f < blocks.first_corner[block + 1]; ++f)
    if (f != e) {
      const EdgeView p(blocks, c, f);
      travel = std::min(travel, lead_travel(p, q, p.depth() - q.depth()));
    }
  return travel;
}

/// Edge e stays the nearest of its block, or keeps meeting that of corner c, for as
/// long as c is inside of it: else it is not asked (ContactDecision::comes_through).
inline double through_travel(const Blocks& blocks, int c, int e, double enough) {
  const double nearest = nearest_travel(blocks, c, e);
  return nearest >= enough
             ? nearest
             : std::max(nearest, meeting_inside_travel(blocks, c, e, true, enough));
}

}  // namespace blocks::dynamics
