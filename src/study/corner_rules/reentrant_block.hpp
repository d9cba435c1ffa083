// The depth test and the "between" test of the variant `corners` for a block that is
// not convex.
#pragma once

#include "geometry/contact_predicates.hpp"
#include "model/blocks.hpp"

namespace blocks::study::corner_rules {

/// A block with re-entrant corners. A corner that is below both edges of a re-entrant
/// corner must come out through both.
class ReentrantBlock {
 public:
  ReentrantBlock(const Blocks& blocks, int block) : blocks_(blocks), block_(block) {}

  /// Whether the block holds the point, or one of its edges is within the slack of it.
  bool holds(const Vec2& c) const {
    for (int e = first(); e < last(); ++e)
      if (on_edge(c, at(e), end(e)))
        return true;
    return contains(c);
  }

  /// Whether the point is in the block or on its outline, without slack.
  bool contains(const Vec2& c) const {
    bool odd = false;
    for (int e = first(); e < last(); ++e) {
      const Vec2 p1 = at(e), p2 = end(e);
      // The ray from c towards +x crosses edges from y <= c.y to y > c.y, or back.
      if ((p1.y() <= c.y()) == (p2.y() <= c.y()))
        continue;
      const int side = geometry::overlap_sign(c, p1, p2);
      if (side == 0)
        return true;
      odd ^= (side > 0) == (p1.y() > p2.y());
    }
    return odd;
  }

  /// The depth test without a centroid, which may lie in front of a re-entrant edge.
  /// The corner may be at most half as deep as the deepest corner of the block.
  bool within_depth(const Vec2& c, int edge) const {
    const Vec2 p1 = at(edge), p2 = end(edge);
    for (int q = first(); q < last(); ++q)
      if (q != edge && q != blocks_.next[edge] &&
          geometry::within_depth(c, halfway(blocks_, edge, q), p1, p2))
        return true;
    return false;
  }

  /// The "between" test at both ends of the edge. At a convex corner, the point must
  /// also be inside the adjacent edge. At a re-entrant corner, the point may be past
  /// the end only if it is past the end of the adjacent edge too.
  bool spans(const Vec2& c, int edge) const {
    const int before = blocks_.previous[edge], after = blocks_.next[edge];
    const bool at_start = turns_inwards(edge)
                              ? !ahead_of(c, edge) || beyond(c, before)
                              : geometry::near_or_inside(c, at(before), end(before));
    return at_start &&
           (turns_inwards(after) ? !beyond(c, edge) || ahead_of(c, after)
                                 : geometry::near_or_inside(c, at(after), end(after)));
  }

  /// Returns the other edge of the re-entrant corner that is the nearest point of both
  /// edges to c, or -1.
  int across_notch(const Vec2& c, int edge) const {
    const int before = blocks_.previous[edge], after = blocks_.next[edge];
    if (turns_inwards(edge) && ahead_of(c, edge) && beyond(c, before))
      return before;
    if (turns_inwards(after) && beyond(c, edge) && ahead_of(c, after))
      return after;
    return -1;
  }

  bool turns_inwards(int corner) const {
    return geometry::overlap_sign(end(corner), at(blocks_.previous[corner]),
                                  at(corner)) < 0;
  }

  /// The stored point that is half as deep below the edge as corner q.
  static Vec2 halfway(const Blocks& blocks, int edge, int q) {
    return 0.5 * (Vec2(blocks.corner.col(q)) + Vec2(blocks.corner.col(edge)));
  }

 private:
  int first() const { return blocks_.first_corner[block_]; }
  int last() const { return blocks_.first_corner[block_ + 1]; }
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  Vec2 end(int edge) const { return at(blocks_.next[edge]); }

  bool on_edge(const Vec2& c, const Vec2& p1, const Vec2& p2) const {
    return geometry::near_or_inside(c, p1, p2) && geometry::near_or_inside(c, p2, p1) &&
           geometry::between(c, p1, p2);
  }
  /// Positive past the middle of the edge, negative before it. The sign is certain for
  /// points not between the ends, which are at least half an edge from the middle.
  double past_middle(const Vec2& c, int edge) const {
    const Vec2 p1 = at(edge), along = end(edge) - p1;
    return (c - p1 - 0.5 * along).dot(along);
  }
  bool ahead_of(const Vec2& c, int edge) const {
    return !geometry::between(c, at(edge), end(edge)) && past_middle(c, edge) < 0.0;
  }
  bool beyond(const Vec2& c, int edge) const {
    return !geometry::between(c, at(edge), end(edge)) && past_middle(c, edge) > 0.0;
  }

  const Blocks& blocks_;
  int block_;
};

}  // namespace blocks::study::corner_rules
