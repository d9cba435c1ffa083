#include "study/corner_rules/corner_decision.hpp"

#include "geometry/contact_predicates.hpp"
#include "study/corner_rules/crossing_sides.hpp"
#include "study/corner_rules/reentrant_block.hpp"

namespace blocks::study::corner_rules {

int CornerDecision::acting_edge(int c, int block) const {
  const int out = place(c, block);
  const int nearest = nearest_edge(c, block, out);
  if (nearest < 0 || !inside(c, nearest))
    return -1;
  return notch_edge(c, block, nearest) < 0 ? seen_edge(c, block, out, nearest)
                                           : nearest;
}

int CornerDecision::notch_edge(int c, int block, int acting) const {
  if (acting < 0 || !reentrant(block))
    return -1;
  const int other = ReentrantBlock(blocks_, block).across_notch(at(c), acting);
  return other >= 0 && inside(c, other) && admissible(c, other, block) ? other : -1;
}

/// Returns the only edge of the block that the corner is outside of, or `none` or
/// `several`. For a block that is not convex it returns `none` if the block holds the
/// corner, otherwise `several`.
int CornerDecision::place(int c, int block) const {
  if (!reentrant(block))
    return place_.outside_of(at(c), block);
  return ReentrantBlock(blocks_, block).holds(at(c)) ? none : several;
}

/// Whether (20) holds for both tangents of the corner.
bool CornerDecision::faces(int c, int edge) const {
  const Vec2 corner = at(c), p1 = at(edge), p2 = end(edge);
  return geometry::faces_edge(corner, at(blocks_.previous[c]), p1, p2) &&
         geometry::faces_edge(corner, at(blocks_.next[c]), p1, p2);
}

/// Whether the block and the edge have a point in common. Two convex shapes are apart
/// if the line of a side of either lies between them. An edge that has a point in
/// another block has an end in it or crosses a side of it.
bool CornerDecision::meets(int edge, int block) const {
  return blocks_.convex[block] ? meets_convex<false>(edge, block)
                               : meets_reentrant(edge, block);
}

/// The same up to the slack, for convex blocks, so that round-off does not decide if
/// bricks touch end to end.
bool CornerDecision::nearly_meets(int edge, int block) const {
  return blocks_.convex[block] ? meets_convex<true>(edge, block)
                               : meets_reentrant(edge, block);
}

template <bool nearly> bool CornerDecision::meets_convex(int edge, int block) const {
  const Vec2 p1 = at(edge), p2 = end(edge);
  const auto beyond = [](const Vec2& c, const Vec2& q1, const Vec2& q2) {
    return nearly ? !geometry::near_or_inside(c, q1, q2)
                  : geometry::overlap_sign(c, q1, q2) < 0;
  };
  bool cut = false;
  for (int q = first(block); q < last(block); ++q) {
    if (beyond(p1, at(q), end(q)) && beyond(p2, at(q), end(q)))
      return false;
    cut = cut ||
          (nearly ? geometry::near_or_inside(at(q), p2, p1) : beyond(at(q), p1, p2));
  }
  return cut;
}

bool CornerDecision::meets_reentrant(int edge, int block) const {
  const Vec2 p1 = at(edge), p2 = end(edge);
  for (int q = first(block); q < last(block); ++q)
    if (geometry::overlap_sign(p1, at(q), end(q)) *
                geometry::overlap_sign(p2, at(q), end(q)) <=
            0 &&
        geometry::overlap_sign(at(q), p1, p2) *
                geometry::overlap_sign(end(q), p1, p2) <=
            0)
      return true;
  return ReentrantBlock(blocks_, block).contains(p1);
}

/// Whether another edge of the block is nearer to a corner inside it.
bool CornerDecision::nearer_edge(int c, int edge) const {
  const int block = blocks_.corner_block[edge];
  for (int f = first(block); f < last(block); ++f)
    if (f != edge && nearer(c, f, edge) &&
        (!reentrant(block) || (geometry::near_or_inside(at(c), at(f), end(f)) &&
                               ReentrantBlock(blocks_, block).spans(at(c), f))))
      return true;
  return false;
}

/// Whether a corner can have entered through the edge. If another edge is nearer, the
/// edge must meet the corner's block. If that block is wholly inside, the edge must be
/// the nearest for another of its corners. The result is true if the corner is outside
/// the edge, because nothing has entered.
bool CornerDecision::comes_through(int c, int edge) const {
  if (!inside(c, edge))
    return true;
  const int own = blocks_.corner_block[c], block = blocks_.corner_block[edge];
  if (!nearer_edge(c, edge) || nearly_meets(edge, own))
    return true;
  for (int f = first(block); f < last(block); ++f)
    if (nearly_meets(f, own))
      return false;
  for (int q = first(own); q < last(own); ++q)
    if (!nearer_edge(q, edge))
      return true;
  return false;
}

/// Whether the depth is within the limit and (20) holds. For a block that is not convex
/// the corner must also be between the ends. The corner is known to be inside a convex
/// block.
bool CornerDecision::admissible(int c, int edge, int block) const {
  const Vec2 corner = at(c), p1 = at(edge), p2 = end(edge);
  if (reentrant(block)) {
    const ReentrantBlock whole(blocks_, block);
    return geometry::near_or_inside(corner, p1, p2) && whole.spans(corner, edge) &&
           whole.within_depth(corner, edge) && faces(c, edge);
  }
  return geometry::within_depth(corner, blocks_.centroid.col(block), p1, p2) &&
         faces(c, edge);
}

/// Whether an edge acts on a corner that is outside the block only because of the side
/// `out`. That side is adjacent to the edge, and a side of the corner's block crosses
/// it.
bool CornerDecision::acts_beside_crossing(int c, int edge, int out) const {
  if (out != blocks_.next[edge] && out != blocks_.previous[edge])
    return false;
  const bool after = out == blocks_.next[edge];
  const int block = blocks_.corner_block[edge];
  const Vec2 corner = at(c), p1 = at(edge), p2 = end(edge);
  if (!geometry::between(corner, p1, p2) || !faces(c, edge))
    return false;
  const CrossingSides sides(blocks_, c, edge, after);
  if (reentrant(block)) {  // the other edges are not tested yet
    const ReentrantBlock whole(blocks_, block);
    if (whole.turns_inwards(after ? out : edge) ||
        geometry::near_or_inside(corner, at(out), end(out)) ||
        !geometry::near_or_inside(corner, p1, p2) ||
        !whole.within_depth(corner, edge) || !far_ends_are_inside(blocks_, sides))
      return false;
  } else if (!geometry::within_depth(corner, blocks_.centroid.col(block), p1, p2)) {
    return false;
  }
  return sides_cross(blocks_, sides, c, edge);
}

/// Whether the edge may act on a corner for which place() returned `out`.
bool CornerDecision::may_act(int c, int edge, int block, int out) const {
  if (out == none)
    return admissible(c, edge, block);
  if (out != several)
    return acts_beside_crossing(c, edge, out);
  return acts_beside_crossing(c, edge, blocks_.previous[edge]) ||
         acts_beside_crossing(c, edge, blocks_.next[edge]);
}

/// Returns the edge that acts after closed joints have hidden the nearest edge, or the
/// corner: the nearest edge, the next one, or -1.
int CornerDecision::seen_edge(int c, int block, int out, int nearest) const {
  const int next = next_edge(c, block, out, nearest);
  if (next >= 0 && joint_.hides_side(c, nearest, next))
    return next;
  if (!joint_.hides_corner(c, nearest))
    return nearest;
  return next >= 0 && joint_.shallow(c, next) && !joint_.hides_corner(c, next) ? next
                                                                               : -1;
}

/// Returns the edge that determines the depth of a corner. At a re-entrant corner it is
/// the edge with the larger depth.
int CornerDecision::depth_edge(int c, int edge) const {
  const int block = blocks_.corner_block[edge];
  if (!reentrant(block))
    return edge;
  const int other = ReentrantBlock(blocks_, block).across_notch(at(c), edge);
  return other >= 0 && nearer(c, edge, other) ? other : edge;
}

/// Whether the depth below the edge is less than below the other one, or there is no
/// other one.
bool CornerDecision::precedes(int c, int edge, int other) const {
  return other < 0 || nearer(c, depth_edge(c, edge), depth_edge(c, other));
}

/// Returns the edge with the least depth that may act, or -1. If the corner is inside
/// several such edges, one that meets the corner's block comes first.
int CornerDecision::nearest_edge(int c, int block, int out) const {
  int found = -1, count = 0;
  if (out == several && !reentrant(block))
    return found;
  const int own = blocks_.corner_block[c];
  const auto may = [&](int edge) {
    return may_act(c, edge, block, out) && (out != none || comes_through(c, edge));
  };
  for (int edge = first(block); edge < last(block); ++edge)
    if (may(edge)) {
      ++count;
      if (precedes(c, edge, found))
        found = edge;
    }
  if (out != none || count < 2 || !inside(c, found) || meets(found, own))
    return found;
  int met = -1;
  for (int edge = first(block); edge < last(block); ++edge)
    if (edge != found && may(edge) && precedes(c, edge, met) && meets(edge, own))
      met = edge;
  return met < 0 ? found : met;
}

/// Returns the edge with the least depth that may act, other than `nearest`, or -1. It
/// need not meet the corner's block.
int CornerDecision::next_edge(int c, int block, int out, int nearest) const {
  int found = -1;
  for (int edge = first(block); edge < last(block); ++edge)
    if (edge != nearest && may_act(c, edge, block, out) && precedes(c, edge, found))
      found = edge;
  return found;
}

}  // namespace blocks::study::corner_rules
