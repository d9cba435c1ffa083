// What closed joints hide (rule 7). The program asks it in doubles; here differences of
// points are exact before they are rounded, and answers within the rounding of the
// program's numbers are `either`.
#include <algorithm>
#include <cmath>

#include "audit/exact_decision.hpp"

namespace blocks::audit {
namespace {

constexpr double most_depth = 0.03, most_way = 0.06, least_slope = 0.25,
                 least_flank = 0.02, least_cosine = 0.95;

Answer both(Answer a, Answer b) { return std::min(a, b); }
Answer one_of(Answer a, Answer b) { return std::max(a, b); }
Answer exactly(bool yes) { return yes ? Answer::yes : Answer::no; }
Answer opposite(Answer a) { return a == Answer::either ? a : exactly(a == Answer::no); }

/// Whether a number is at least zero, if it may be wrong by this much.
Answer at_least_zero(double number, double error) {
  return std::abs(number) <= error ? Answer::either : exactly(number > 0.0);
}

double cross_of(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

/// The difference of two points, [L].
Vec2 ExactRules::rounded(const Point& difference) const {
  return {lattice_.rounded(difference.x, 1), lattice_.rounded(difference.y, 1)};
}

/// [L] What doubles may lose in a point shifted from a corner. A coordinate is rounded
/// to 2^-53 of itself, and so are the handful of products behind the shift.
double ExactRules::roundoff(int corner, int edge) const {
  const Vec2 c = blocks_.corner.col(corner);
  const double size =
      rounded(along(edge)).norm() + (c - Vec2(blocks_.corner.col(edge))).lpNorm<1>();
  return 0x1p-48 * (c.lpNorm<1>() + size);
}

/// The nearest edge acts; where it is hidden the next; where the corner is hidden the
/// next, if that is not too deep and hides it no less, or none.
void ExactRules::look_at_joints(Decision& decision) const {
  const int c = decision.corner, nearest = decision.nearest, next = decision.next;
  if (next >= 0)
    decision.side = hides_side(c, nearest, next);
  if (decision.side.answer != Answer::yes)
    decision.hidden = hides_corner(c, nearest);
  const Answer side = decision.side.answer, hidden = decision.hidden.answer;
  const Answer serves =
      next < 0 ? Answer::no
               : both(shallow(c, next), opposite(hides_corner(c, next).answer));
  std::vector<int>& possible = decision.possible;
  possible.clear();
  if (side != Answer::yes && hidden != Answer::yes)
    possible.push_back(nearest);
  if (side != Answer::no || (hidden != Answer::no && serves != Answer::no))
    possible.push_back(next);
  if (side != Answer::yes && hidden != Answer::no && serves != Answer::yes)
    possible.push_back(-1);
  decision.acting = possible.front();
}

/// The side is hidden from the corner: beyond it, along the surface, a third block goes
/// on, and the corner's block lies over it, or holds the vertex of side and surface.
Shield ExactRules::hides_side(int corner, int edge, int surface) const {
  Shield found;
  const Answer not_deep = shallow(corner, surface);
  for (const double part : {1.0, 0.25, 0.0625}) {
    const Way there = way(corner, edge, surface, part * overlap(corner, surface));
    Shield here = goes_on(there, Answer::yes);
    here.answer = both(both(not_deep, reaches_over(there)), here.answer);
    if (here.answer > found.answer || found.corner < 0)
      found = here;
  }
  const int vertex = blocks_.next[edge] == surface   ? surface
                     : blocks_.next[surface] == edge ? edge
                                                     : -1;
  const int own = blocks_.corner_block[corner];
  if (vertex >= 0 && blocks_.convex[own]) {
    double closed = overlap(corner, surface), error = roundoff(corner, surface);
    for (int q = blocks_.first_corner[own]; q < blocks_.first_corner[own + 1]; ++q) {
      closed = std::min(closed, overlap(vertex, q));
      error = std::max(error, roundoff(vertex, q));
    }
    Way there = way(corner, edge, surface, closed);
    there.error += error;
    Shield here = goes_on(there, Answer::yes);
    here.answer = both(both(not_deep, at_least_zero(closed, error)), here.answer);
    if (here.answer > found.answer)
      found = here;
  }
  found.depth = overlap(corner, surface);
  found.reach = most_depth * rounded(along(surface)).norm();
  return found;
}

/// The corner is hidden from the edge, by either of the two edges that meet in it.
Shield ExactRules::hides_corner(int corner, int edge) const {
  const int before = blocks_.previous[corner];
  const Shield one = hidden(corner, edge, before, corner);
  const Shield two = hidden(corner, edge, corner, before);
  return two.answer > one.answer ? two : one;
}

Shield ExactRules::hidden(int corner, int edge, int side, int surface) const {
  const Vec2 flank = rounded(along(edge)).normalized(),
             along_surface = rounded(along(surface)).normalized();
  const Answer slopes =
      at_least_zero(std::abs(cross_of(flank, along_surface)) - least_flank, 1e-12);
  const int toe = slopes == Answer::no ? -1 : toe_of(edge, surface);
  if (toe < 0)
    return {};
  const double depth = overlap(toe, surface);
  const Answer below = both(at_least_zero(depth, roundoff(toe, surface)),
                            both(slopes, shallow(toe, surface)));
  const Answer inside = exactly(place(toe, blocks_.corner_block[corner]).inside);
  const double closed = std::min(depth, overlap(corner, edge));
  Way near = way(toe, side, surface, closed), far = way(toe, side, surface, depth);
  near.error += roundoff(corner, edge);
  Shield found = goes_on(near, inside), over = goes_on(far, Answer::yes);
  over.answer = both(both(inside, reaches_over(far)), over.answer);
  if (over.answer > found.answer)
    found = over;
  found.answer = both(below, found.answer);
  found.depth = depth, found.reach = most_depth * rounded(along(surface)).norm();
  return found;
}

/// From the end of the edge that lies deeper below the surface on, the first corner of
/// its block that faces the surface; -1: none.
int ExactRules::toe_of(int edge, int surface) const {
  const bool forward = area2(blocks_.next[edge], surface) > area2(edge, surface);
  int toe = forward ? blocks_.next[edge] : edge;
  for (int left = blocks_.corners_of(blocks_.corner_block[edge]); left > 0; --left) {
    if (faces(toe, blocks_.previous[toe], surface) &&
        faces(toe, blocks_.next[toe], surface))
      return toe;
    toe = forward ? blocks_.next[toe] : blocks_.previous[toe];
  }
  return -1;
}

ExactRules::Way ExactRules::way(int corner, int side, int surface, double gap) const {
  const Vec2 across = rounded(along(side)).normalized(), f = rounded(along(surface));
  const Vec2 unit = f.normalized();
  const double slope = cross_of(across, unit);
  const double loss = roundoff(corner, side) + roundoff(corner, surface);
  Way there;
  there.corner = corner, there.block = blocks_.corner_block[side];
  there.along = unit, there.depth = overlap(corner, surface);
  there.shift = (overlap(corner, side) + gap) / slope * unit;
  there.error = 2.0 * loss / std::abs(slope);
  there.possible =
      both(at_least_zero(std::abs(slope) - least_slope, 1e-12),
           at_least_zero(most_way * f.norm() - there.shift.norm(), there.error));
  return there;
}

/// The surface goes on in a third block, which holds the corner if it is not `inside`
/// the block of the surface.
Shield ExactRules::goes_on(const Way& way, Answer inside) const {
  Shield found;
  found.corner = way.corner;
  if (way.possible == Answer::no)
    return found;
  for (const int third : near_[way.corner]) {
    if (third == way.block || !blocks_.convex[third])
      continue;
    const Answer held = one_of(inside, exactly(place(way.corner, third).inside));
    const Answer answer = both(both(way.possible, held), has_surface(third, way));
    if (answer > found.answer)
      found.answer = answer, found.third = third;
  }
  return found;
}

/// The end of the way is inside the block, and below an edge that runs along the
/// surface by half to twice the depth.
Answer ExactRules::has_surface(int block, const Way& way) const {
  Answer inside = Answer::yes, found = Answer::no;
  for (int q = blocks_.first_corner[block]; q < blocks_.first_corner[block + 1]; ++q) {
    const Vec2 edge = rounded(along(q));
    const double length = edge.norm();
    const Vec2 from = rounded(corner_[way.corner] - corner_[q]) + way.shift;
    const double below = cross_of(from, edge) / length;
    const double loss = way.error + roundoff(way.corner, q);
    inside = both(inside, at_least_zero(below, loss));
    const Answer runs =
        at_least_zero(edge.dot(way.along) / length - least_cosine, 1e-12);
    const Answer as_deep = both(at_least_zero(below - 0.5 * way.depth, loss),
                                at_least_zero(2.0 * way.depth - below, 2.0 * loss));
    const Answer long_enough =
        at_least_zero(most_way * length - way.shift.norm(), 2.0 * loss);
    found = one_of(found, both(runs, both(as_deep, long_enough)));
  }
  return both(inside, found);
}

/// The corner's own block is over the end of the way, seen at some heights up to the
/// surface.
Answer ExactRules::reaches_over(const Way& way) const {
  const Vec2 height = way.depth * Vec2(-way.along.y(), way.along.x());
  Answer over = Answer::no;
  for (const double part : {0.05, 0.3, 0.75, 0.97})
    over = one_of(over, reaches(blocks_.corner_block[way.corner], way.corner,
                                way.shift + part * height, way.error));
  return over;
}

/// The point that lies `shift` from the corner is in the block. Not convex: a ray
/// upwards leaves it once more than it enters, or an edge is as near as the slack.
Answer ExactRules::reaches(int block, int corner, const Vec2& shift,
                           double error) const {
  constexpr double slack = 1e-6;
  Answer inside = Answer::yes, near = Answer::no;
  bool odd = false;
  for (int q = blocks_.first_corner[block]; q < blocks_.first_corner[block + 1]; ++q) {
    const Vec2 edge = rounded(along(q));
    const Vec2 from = rounded(corner_[corner] - corner_[q]) + shift;
    const double length = edge.norm(), loss = error + roundoff(corner, q);
    const double below = cross_of(from, edge) / length, at = from.dot(edge) / length;
    inside = both(inside, at_least_zero(below, loss));
    if ((from.x() < 0.0) != (from.x() < edge.x()))
      odd ^= from.y() < edge.y() / edge.x() * from.x();
    near = one_of(near, both(at_least_zero(slack * length - std::abs(below), loss),
                             both(at_least_zero(at + slack * length, loss),
                                  at_least_zero((1.0 + slack) * length - at, loss))));
  }
  if (blocks_.convex[block])
    return inside;
  return one_of(near, exactly(odd));
}

/// Not too deep below the edge.
Answer ExactRules::shallow(int corner, int edge) const {
  const double most = most_depth * rounded(along(edge)).norm();
  return at_least_zero(most - overlap(corner, edge), roundoff(corner, edge));
}

}  // namespace blocks::audit
