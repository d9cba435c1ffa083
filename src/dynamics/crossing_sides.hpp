// Blocks on top of each other whose sides cross, so that neither corner of the common
// face lies in the other block (docs/departures.md#crossing-sides). A template over the
// rules of the decision, as in contact_decision.hpp.
#pragma once

#include "geometry/vec2.hpp"
#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Corner c has passed the side f of a convex block, next to the edge that it is
/// behind; their common corner v has passed the side g of the block of c.
struct CrossingSides {
  int side;        ///< f, an edge of the block hit
  int vertex;      ///< v, a corner of it
  int vertex_far;  ///< the other end of f
  int own;         ///< g, an edge of the block of c
  int own_far;     ///< the end of g that is not c

  /// For the side before or after the edge.
  CrossingSides(const Blocks& blocks, int c, int edge, bool after)
      : side(after ? blocks.next[edge] : blocks.previous[edge]),
        vertex(after ? blocks.next[edge] : edge),
        vertex_far(after ? blocks.next[side] : side),
        own(after ? blocks.previous[c] : c),
        own_far(after ? blocks.previous[c] : blocks.next[c]) {}

  /// For the edge after the side f, or before it.
  static CrossingSides beside(const Blocks& blocks, int c, int side, bool after) {
    const int edge = after ? blocks.next[side] : blocks.previous[side];
    return {blocks, c, edge, !after};
  }

  struct Question {
    int corner, edge;
    bool outside;
  };
  static constexpr unsigned most_apart = 3;
  /// A corner that is outside of an edge, or is not: f and g do not cross. One of
  /// three.
  Question apart(unsigned number) const {
    return number == 1   ? Question{vertex, own, false}
           : number == 2 ? Question{own_far, side, true}
                         : Question{vertex_far, own, true};
  }
};

/// Whether f and g cross between v and c, c being outside of f: of a slanted joint that
/// is closed they do not, c and v pass on the same side. Both leave the edge by more
/// than the ten degrees of (20), so that they cross no farther from c than six times
/// its depth.
template <class Rules>
bool sides_cross(const Blocks& blocks, const CrossingSides& s, int c, int edge) {
  const auto at = [&](int corner) { return Vec2(blocks.corner.col(corner)); };
  const Vec2 p1 = at(edge), p2 = at(blocks.next[edge]);
  const auto inside = [&](int point, int e) {
    return Rules::inside_edge(at(point), at(e), at(blocks.next[e]));
  };
  return !inside(s.vertex, s.own) && inside(s.own_far, s.side) &&
         inside(s.vertex_far, s.own) &&
         !Rules::faces_edge(at(c), at(s.own_far), p2, p1) &&
         !Rules::faces_edge(at(s.vertex), at(s.vertex_far), p1, p2);
}

/// Asked without slack, with which the lines of f and g could cross beyond their far
/// ends: there a corner would be outside of another edge of a convex block, but of one
/// that is not convex the other edges are not asked.
template <class Rules>
bool far_ends_are_inside(const Blocks& blocks, const CrossingSides& s) {
  const auto overlap_sign = [&](int point, int e) {
    return Rules::overlap_sign(blocks.corner.col(point), blocks.corner.col(e),
                               blocks.corner.col(blocks.next[e]));
  };
  return overlap_sign(s.own_far, s.side) >= 0 && overlap_sign(s.vertex_far, s.own) >= 0;
}

}  // namespace blocks::dynamics
