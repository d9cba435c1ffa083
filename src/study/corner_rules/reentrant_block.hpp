// Depth and "between" of the variant `corners` for a block that is not convex.
#pragma once

#include "geometry/contact_predicates.hpp"
#include "model/blocks.hpp"

namespace blocks::study::corner_rules {

/// A block some of whose corners are re-entrant: they turn inwards. At such a notch a
/// corner below both edges has to come out through both.
class ReentrantBlock {
 public:
  ReentrantBlock(const Blocks& blocks, int block) : blocks_(blocks), block_(block) {}

  /// Whether the block holds the point, or an edge is as near to it as the slack.
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
      // the ray from c towards +x: edges from y <= c.y to y > c.y, or back
      if ((p1.y() <= c.y()) == (p2.y() <= c.y()))
        continue;
      const int side = geometry::overlap_sign(c, p1, p2);
      if (side == 0)
        return true;
      odd ^= (side > 0) == (p1.y() > p2.y());
    }
    return odd;
  }

  /// Depth without a centroid, which may lie in front of a re-entrant edge: the corner
  /// is at most half as deep as the deepest corner of the block.
  bool within_depth(const Vec2& c, int edge) const {
    const Vec2 p1 = at(edge), p2 = end(edge);
    for (int q = first(); q < last(); ++q)
      if (q != edge && q != blocks_.next[edge] &&
          geometry::within_depth(c, halfway(blocks_, edge, q), p1, p2))
        return true;
    return false;
  }

  /// "Between", end by end: at a corner that turns outwards inside of the next edge
  /// too, as in a convex block; at a notch no farther than its ends, or in the notch.
  bool spans(const Vec2& c, int edge) const {
    const int before = blocks_.previous[edge], after = blocks_.next[edge];
    const bool at_start = turns_inwards(edge)
                              ? !ahead_of(c, edge) || beyond(c, before)
                              : geometry::near_or_inside(c, at(before), end(before));
    return at_start &&
           (turns_inwards(after) ? !beyond(c, edge) || ahead_of(c, after)
                                 : geometry::near_or_inside(c, at(after), end(after)));
  }

  /// The other edge of the notch whose corner is the point of both edges that is
  /// nearest to c, or -1.
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

  /// The point that is half as deep below the edge as corner q, as stored.
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
  /// Not between, so half an edge away from the middle at least: the sign is sure.
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
