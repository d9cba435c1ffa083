// Blocks on top of each other whose sides cross, so that neither corner of the common
// face lies in the other block. For the variant `corners`.
#pragma once

#include "geometry/contact_predicates.hpp"
#include "model/blocks.hpp"

namespace blocks::study::corner_rules {

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
};

/// Whether f and g cross between v and c, c being outside of f: of a slanted joint that
/// is closed they do not, c and v pass on the same side. Both leave the edge by more
/// than the ten degrees of (20), so that they cross no farther from c than six times
/// its depth.
inline bool sides_cross(const Blocks& blocks, const CrossingSides& s, int c, int edge) {
  const auto at = [&](int corner) { return Vec2(blocks.corner.col(corner)); };
  const Vec2 p1 = at(edge), p2 = at(blocks.next[edge]);
  const auto inside = [&](int point, int e) {
    return geometry::near_or_inside(at(point), at(e), at(blocks.next[e]));
  };
  return !inside(s.vertex, s.own) && inside(s.own_far, s.side) &&
         inside(s.vertex_far, s.own) &&
         !geometry::faces_edge(at(c), at(s.own_far), p2, p1) &&
         !geometry::faces_edge(at(s.vertex), at(s.vertex_far), p1, p2);
}

/// Asked without slack, with which the lines of f and g could cross beyond their far
/// ends: there a corner would be outside of another edge of a convex block, but of one
/// that is not convex the other edges are not asked.
inline bool far_ends_are_inside(const Blocks& blocks, const CrossingSides& s) {
  const auto overlap_sign = [&](int point, int e) {
    return geometry::overlap_sign(blocks.corner.col(point), blocks.corner.col(e),
                                  blocks.corner.col(blocks.next[e]));
  };
  return overlap_sign(s.own_far, s.side) >= 0 && overlap_sign(s.vertex_far, s.own) >= 0;
}

}  // namespace blocks::study::corner_rules
