#include "audit/exact_decision.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "audit/neighbours.hpp"

namespace blocks::audit {
namespace {

/// Sign of a / sqrt(p) - b / sqrt(q), p and q above zero.
int compare_over_roots(const Whole& a, const Whole& p, const Whole& b, const Whole& q) {
  if (sign(a) != sign(b))
    return sign(a) > sign(b) ? 1 : -1;
  return sign(a) * (a * a * q).compare(b * b * p);
}

}  // namespace

ExactRules::ExactRules(const Blocks& blocks, double reach)
    : blocks_(blocks), near_(blocks_near_corners(blocks, reach)), slack_(1e-6) {
  for (const auto* points : {&blocks.corner, &blocks.centroid})
    for (const double x : points->reshaped())
      lattice_.include(x);
  for (int e = 0; e < blocks.corners(); ++e) {
    const int b = blocks.corner_block[e];
    for (int q = blocks.first_corner[b]; q < blocks.first_corner[b + 1]; ++q)
      if (!blocks.convex[b])
        for (const double x : halfway(e, q))
          lattice_.include(x);
  }
  for (int c = 0; c < blocks.corners(); ++c)
    corner_.push_back(lattice_(Vec2(blocks.corner.col(c))));
  for (int b = 0; b < blocks.size(); ++b) {
    centroid_.push_back(lattice_(Vec2(blocks.centroid.col(b))));
  }
}

Point ExactRules::along(int edge) const {
  return corner_[blocks_.next[edge]] - corner_[edge];
}

Whole ExactRules::length2(int edge) const {
  const Point e = along(edge);
  return dot(e, e);
}

/// 2A of (19).
Whole ExactRules::area2(int corner, int edge) const {
  return cross(corner_[corner] - corner_[edge], along(edge));
}

/// d >= -eps L, that is 2A + eps L^2 >= 0.
bool ExactRules::near_or_inside(int corner, int edge) const {
  return sign((area2(corner, edge) << slack_.shift) +
              slack_.numerator * length2(edge)) >= 0;
}

/// d <= eps L.
bool ExactRules::near_or_outside(int corner, int edge) const {
  return sign((area2(corner, edge) << slack_.shift) -
              slack_.numerator * length2(edge)) <= 0;
}

/// -eps L^2 <= s L <= (1 + eps) L^2.
bool ExactRules::between(int corner, int edge) const {
  const Whole s = dot(corner_[corner] - corner_[edge], along(edge));
  const Whole l = length2(edge), slack = slack_.numerator * l;
  return sign((s << slack_.shift) + slack) >= 0 &&
         sign(((l - s) << slack_.shift) + slack) >= 0;
}

/// The point between corner q and the edge's first corner: what is stored of it counts.
Vec2 ExactRules::halfway(int edge, int q) const {
  return 0.5 * (Vec2(blocks_.corner.col(q)) + Vec2(blocks_.corner.col(edge)));
}

/// 2A of the corner is at most that of the centroid; of a block that is not convex at
/// most half that of its deepest corner.
bool ExactRules::within_depth(int corner, int edge) const {
  const int b = blocks_.corner_block[edge];
  const auto above = [&](const Point& g) {
    return sign(cross(corner_[corner] - g, along(edge))) <= 0;
  };
  if (blocks_.convex[b])
    return above(centroid_[b]);
  for (int q = blocks_.first_corner[b]; q < blocks_.first_corner[b + 1]; ++q)
    if (q != edge && q != blocks_.next[edge] && above(lattice_(halfway(edge, q))))
      return true;
  return false;
}

/// (20): t.n >= -sin 10. With s = -t.n > 0 this is s <= sin 10, and below 30 degrees
/// the same as sin of the triple angle, 3 s - 4 s^3, <= 1/2. With s = D / sqrt(Q), D
/// the cross product and Q = |e|^2 |t|^2, squared: 4 D^2 (3 Q - 4 D^2)^2 <= Q^3.
bool ExactRules::faces(int corner, int neighbour, int edge) const {
  const Point t = corner_[neighbour] - corner_[corner];
  const Whole d = cross(along(edge), t);
  if (sign(d) >= 0)
    return true;
  const Whole q = length2(edge) * dot(t, t), d2 = d * d;
  if (4 * d2 >= q)
    return false;
  const Whole rest = 3 * q - 4 * d2;
  return 4 * d2 * rest * rest <= q * q * q;
}

ExactRules::Place ExactRules::place(int corner, int block) const {
  if (!blocks_.convex[block])
    return place_by_rays(corner, block);
  Place place{true, -1};
  for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e) {
    if (near_or_inside(corner, e))
      continue;
    if (place.beyond >= 0)
      return {};
    place = {false, e};
  }
  return place;
}

/// Inside: by a ray, or an edge is as near as the slack.
ExactRules::Place ExactRules::place_by_rays(int corner, int block) const {
  for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e) {
    const Whole slack = slack_.numerator * length2(e);
    if (near_or_inside(corner, e) && between(corner, e) &&
        sign(slack - (area2(corner, e) << slack_.shift)) >= 0)
      return {true, -1};
  }
  return {rays_say_inside(corner, block), -1};
}

/// A ray straight up leaves the block once more than it enters; of points that are not
/// on its outline.
bool ExactRules::rays_say_inside(int corner, int block) const {
  const Point& c = corner_[corner];
  int crossings = 0;
  for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e) {
    const Point &p = corner_[e], &q = corner_[blocks_.next[e]];
    if ((p.x > c.x) != (q.x > c.x))
      // the edge is above: to the right is inside of a clockwise block
      crossings +=
          (q.x > p.x) ? (sign(area2(corner, e)) > 0) : -(sign(area2(corner, e)) < 0);
  }
  return crossings != 0;
}

bool ExactRules::turns_inwards(int corner) const {
  return sign(cross(along(corner), along(blocks_.previous[corner]))) < 0;
}

/// 0: between the ends of the edge, -1: before the first, 1: beyond the second.
int ExactRules::past(int corner, int edge) const {
  if (between(corner, edge))
    return 0;
  return sign(dot(corner_[corner] - corner_[edge], along(edge))) < 0 ? -1 : 1;
}

/// The place along an edge of a block that is not convex, end by end.
bool ExactRules::spans(int corner, int edge) const {
  const int before = blocks_.previous[edge], after = blocks_.next[edge];
  const int at = past(corner, edge);
  const bool start = turns_inwards(edge) ? at >= 0 || past(corner, before) > 0
                                         : near_or_inside(corner, before);
  const bool end = turns_inwards(after) ? at <= 0 || past(corner, after) < 0
                                        : near_or_inside(corner, after);
  return start && end;
}

/// The other edge of a notch, where the corner is beyond the ends of both.
int ExactRules::across_notch(int corner, int edge) const {
  const int before = blocks_.previous[edge], after = blocks_.next[edge];
  const int at = past(corner, edge);
  if (at < 0 && turns_inwards(edge) && past(corner, before) > 0)
    return before;
  if (at > 0 && turns_inwards(after) && past(corner, after) < 0)
    return after;
  return -1;
}

/// From `from` to `to` the way leads out of the edge (way 1) or into it (-1) by more
/// than ten degrees: way t.n > sin 10, squared as in `faces`.
bool ExactRules::steep(int from, int to, int edge, int way) const {
  const Point t = corner_[to] - corner_[from];
  const Whole out = -way * cross(t, along(edge));  // |t| |e| t.n
  if (sign(out) <= 0)
    return false;
  const Whole q = length2(edge) * dot(t, t), d2 = out * out;
  if (4 * d2 >= q)
    return true;
  const Whole rest = 3 * q - 4 * d2;
  return 4 * d2 * rest * rest > q * q * q;
}

/// The corner is beyond a neighbour f of the edge, and f and the side of the corner's
/// block that is next to the face on the edge cross: each has one end on either side of
/// the other.
bool ExactRules::crosses(int corner, int edge, int beyond) const {
  const bool after = beyond == blocks_.next[edge];
  if (!after && beyond != blocks_.previous[edge])
    return false;
  const int vertex = after ? beyond : edge;
  const int far = after ? blocks_.next[beyond] : beyond;
  const int side = after ? blocks_.previous[corner] : corner;
  const int own_far = after ? side : blocks_.next[corner];
  return between(corner, edge) && near_or_inside(own_far, beyond) &&
         near_or_inside(far, side) && !near_or_inside(vertex, side) &&
         steep(corner, own_far, edge, 1) && steep(vertex, far, edge, -1);
}

/// The edge acts for the sake of a crossing. beyond: the only edge of a convex block
/// that the corner is outside of; of another block each neighbour of the edge is asked.
bool ExactRules::admits_crossing(int corner, int edge, int beyond) const {
  if (!within_depth(corner, edge) || !faces(corner, blocks_.previous[corner], edge) ||
      !faces(corner, blocks_.next[corner], edge))
    return false;
  if (blocks_.convex[blocks_.corner_block[edge]])
    return beyond >= 0 && crosses(corner, edge, beyond);
  if (!near_or_inside(corner, edge))
    return false;
  const int before = blocks_.previous[edge], after = blocks_.next[edge];
  const auto have_a_common_point = [&](int side, int far, int own, int own_far) {
    return sign(area2(own_far, side)) >= 0 && sign(area2(far, own)) >= 0;
  };
  return (!turns_inwards(edge) && !near_or_inside(corner, before) &&
          crosses(corner, edge, before) &&
          have_a_common_point(before, before, corner, blocks_.next[corner])) ||
         (!turns_inwards(after) && !near_or_inside(corner, after) &&
          crosses(corner, edge, after) &&
          have_a_common_point(after, blocks_.next[after], blocks_.previous[corner],
                              blocks_.previous[corner]));
}

/// The edge and the block have a point in common. Convex: the block is not wholly
/// behind the edge, and no side of it has both ends of the edge beyond it. Else: a side
/// crosses or touches the edge, or an end of it is in the block.
bool ExactRules::meets(int edge, int block) const {
  const int end = blocks_.next[edge];
  bool cut = false;
  for (int q = blocks_.first_corner[block]; q < blocks_.first_corner[block + 1]; ++q) {
    const int from = sign(area2(q, edge)), to = sign(area2(blocks_.next[q], edge));
    const int first = sign(area2(edge, q)), second = sign(area2(end, q));
    if (blocks_.convex[block] && std::max(first, second) < 0)
      return false;
    if (!blocks_.convex[block] && first * second <= 0 && from * to <= 0)
      return true;
    cut |= from < 0;
  }
  return blocks_.convex[block] ? cut : rays_say_inside(edge, block);
}

/// The same, up to the slack where the block is convex.
bool ExactRules::nearly_meets(int edge, int block) const {
  if (!blocks_.convex[block])
    return meets(edge, block);
  const int end = blocks_.next[edge];
  bool cut = false;
  for (int q = blocks_.first_corner[block]; q < blocks_.first_corner[block + 1]; ++q) {
    if (!near_or_inside(edge, q) && !near_or_inside(end, q))
      return false;
    cut |= near_or_outside(q, edge);
  }
  return cut;
}

/// Another edge of the block is nearer to a corner inside.
bool ExactRules::nearer_edge(int corner, int edge) const {
  const int block = blocks_.corner_block[edge];
  for (int f = blocks_.first_corner[block]; f < blocks_.first_corner[block + 1]; ++f)
    if (f != edge && compare_depth(corner, f, edge) < 0 &&
        (blocks_.convex[block] || (near_or_inside(corner, f) && spans(corner, f))))
      return true;
  return false;
}

/// An edge that is not the nearest of all has to meet the corner's block; one that is
/// wholly inside comes out through the edges that are nearest to its corners. Of an
/// edge that the corner is not behind it is not asked.
bool ExactRules::comes_through(int corner, int edge) const {
  if (sign(area2(corner, edge)) <= 0)
    return true;
  const int own = blocks_.corner_block[corner], block = blocks_.corner_block[edge];
  bool touches = false, nearest_to_one = false;
  for (int f = blocks_.first_corner[block]; f < blocks_.first_corner[block + 1]; ++f)
    touches |= nearly_meets(f, own);
  for (int q = blocks_.first_corner[own]; q < blocks_.first_corner[own + 1]; ++q)
    nearest_to_one |= !nearer_edge(q, edge);
  return !nearer_edge(corner, edge) || nearly_meets(edge, own) ||
         (!touches && nearest_to_one);
}

bool ExactRules::admits(int corner, int edge) const {
  return within_depth(corner, edge) &&
         (blocks_.convex[blocks_.corner_block[edge]] ||
          (near_or_inside(corner, edge) && spans(corner, edge))) &&
         faces(corner, blocks_.previous[corner], edge) &&
         faces(corner, blocks_.next[corner], edge);
}

int ExactRules::compare_depth(int corner, int edge, int other) const {
  return compare_over_roots(area2(corner, edge), length2(edge), area2(corner, other),
                            length2(other));
}

/// Less deep; in a notch that is below the deeper one of both edges.
bool ExactRules::comes_before(int corner, int edge, int other) const {
  const auto deeper = [&](int e) {
    if (blocks_.convex[blocks_.corner_block[e]])
      return e;
    const int f = across_notch(corner, e);
    return f >= 0 && compare_depth(corner, f, e) > 0 ? f : e;
  };
  return compare_depth(corner, deeper(edge), deeper(other)) < 0;
}

/// Of edges equally deep the first in the order of the block comes first.
ExactRules::Two ExactRules::nearest_edges(int corner, int block,
                                          const Place& place) const {
  Two found;
  if (!place.inside && place.beyond < 0 && blocks_.convex[block])
    return found;
  std::vector<int> admitted, first;
  for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e)
    if (place.inside ? admits(corner, e) : admits_crossing(corner, e, place.beyond))
      admitted.push_back(e);
  for (const int e : admitted)
    if (!place.inside || comes_through(corner, e))
      first.push_back(e);
  const auto nearest_of_first = [&] {
    int nearest = -1;
    for (const int e : first)
      if (nearest < 0 || comes_before(corner, e, nearest))
        nearest = e;
    return nearest;
  };
  found.nearest = nearest_of_first();
  // inside of several, those that the corner's block meets come first
  const auto met = [&](int e) { return meets(e, blocks_.corner_block[corner]); };
  if (place.inside && found.nearest >= 0 && sign(area2(corner, found.nearest)) > 0 &&
      std::any_of(first.begin(), first.end(), met)) {
    std::erase_if(first, std::not_fn(met));
    found.nearest = nearest_of_first();
  }
  for (const int e : admitted)
    if (found.nearest >= 0 && e != found.nearest &&
        (found.next < 0 || comes_before(corner, e, found.next)))
      found.next = e;
  return found;
}

Decision ExactRules::decide(int corner, int block) const {
  Decision decision;
  decision.corner = corner, decision.block = block;
  const Place where = place(corner, block);
  const Two edges = nearest_edges(corner, block, where);
  decision.inside = where.inside;
  decision.crossing = !where.inside && edges.nearest >= 0;
  decision.nearest = edges.nearest, decision.next = edges.next;
  if (edges.nearest < 0 || sign(area2(corner, edges.nearest)) <= 0)
    return decision;
  decision.possible = {decision.acting = edges.nearest};
  if (!blocks_.convex[block]) {
    const int other = across_notch(corner, edges.nearest);
    if (other >= 0 && admits(corner, other) && sign(area2(corner, other)) > 0)
      decision.notch = other;
  }
  if (decision.notch < 0)
    look_at_joints(decision);
  return decision;
}

double ExactRules::overlap(int corner, int edge) const {
  return lattice_.rounded(area2(corner, edge), 2) /
         std::sqrt(lattice_.rounded(length2(edge), 2));
}

EdgeStory ExactRules::examine(int corner, int edge) const {
  const int block = blocks_.corner_block[edge];
  const Point e = along(edge), from = corner_[corner] - corner_[edge];
  const auto value = [&](const Whole& n) { return lattice_.rounded(n, 2); };
  const auto tangent = [&](int neighbour) {
    const Point t = corner_[neighbour] - corner_[corner];
    return value(cross(e, t)) / std::sqrt(value(dot(e, e)) * value(dot(t, t)));
  };
  EdgeStory story;
  story.edge = edge;
  story.length = std::sqrt(value(length2(edge)));
  story.overlap = overlap(corner, edge);
  const auto depth = [&](const Point& p) {
    return value(cross(p - corner_[edge], e)) / story.length;
  };
  if (blocks_.convex[block])
    story.depth_limit = depth(centroid_[block]);
  else
    for (int q = blocks_.first_corner[block]; q < blocks_.first_corner[block + 1]; ++q)
      story.depth_limit =
          std::max(story.depth_limit, depth(lattice_(halfway(edge, q))));
  story.along = value(dot(from, e)) / value(dot(e, e));
  story.tangent_before = tangent(blocks_.previous[corner]);
  story.tangent_after = tangent(blocks_.next[corner]);
  story.overlap_sign = sign(area2(corner, edge));
  story.near_or_inside = near_or_inside(corner, edge);
  story.within_depth = within_depth(corner, edge);
  const Place where = place(corner, block);
  story.between = blocks_.convex[block] ? between(corner, edge) : spans(corner, edge);
  story.facing_before = faces(corner, blocks_.previous[corner], edge);
  story.facing_after = faces(corner, blocks_.next[corner], edge);
  story.comes_through = comes_through(corner, edge);
  story.admissible =
      where.inside ? admits(corner, edge) : admits_crossing(corner, edge, where.beyond);
  return story;
}

}  // namespace blocks::audit
