// Stacked blocks whose sides cross, so that neither corner of the common face lies in
// the other block. For the variant `corners`.
#pragma once

#include "geometry/contact_predicates.hpp"
#include "model/blocks.hpp"

namespace blocks::study::corner_rules {

/// Corner c is behind an edge of a convex block, but has passed the side f next to it.
/// The common corner v of the edge and f has passed the side g of the block of c.
struct CrossingSides {
  int side;        ///< f, an edge of the block that c hit
  int vertex;      ///< v, a corner of the block hit
  int vertex_far;  ///< the other end of f
  int own;         ///< g, an edge of the block of c
  int own_far;     ///< the end of g that is not c

  /// `after` selects the side after the edge; otherwise it is the side before.
  CrossingSides(const Blocks& blocks, int c, int edge, bool after)
      : side(after ? blocks.next[edge] : blocks.previous[edge]),
        vertex(after ? blocks.next[edge] : edge),
        vertex_far(after ? blocks.next[side] : side),
        own(after ? blocks.previous[c] : c),
        own_far(after ? blocks.previous[c] : blocks.next[c]) {}
};

/// Whether f and g cross between v and c, where c is outside f. They do not cross at a
/// slanted closed joint, because c and v pass on the same side. Both leave the edge by
/// more than the ten degrees of (20), so that they cross within six times the depth of
/// c.
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

/// Whether the far ends of f and g are inside, tested without slack. With slack, the
/// lines of f and g could cross beyond their far ends. A corner there would be outside
/// another edge of a convex block. For other blocks the other edges are not tested.
inline bool far_ends_are_inside(const Blocks& blocks, const CrossingSides& s) {
  const auto overlap_sign = [&](int point, int e) {
    return geometry::overlap_sign(blocks.corner.col(point), blocks.corner.col(e),
                                  blocks.corner.col(blocks.next[e]));
  };
  return overlap_sign(s.own_far, s.side) >= 0 && overlap_sign(s.vertex_far, s.own) >= 0;
}

}  // namespace blocks::study::corner_rules
