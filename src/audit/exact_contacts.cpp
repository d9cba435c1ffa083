// Finds the contacts along the axis that acts (docs/contact-rule.md#contacts), and
// whether a side has an end where the foot of a corner is beyond it.
#include <algorithm>

#include "audit/exact_pair_rule.hpp"

namespace blocks::audit {

/// Returns whether the next side is in line with a side: the far corner of each is at
/// most the slack outside the other side.
bool ExactPairRule::in_line(const PartSide& side, const PartSide& next) const {
  const Point e = line(side).along, g = line(next).along;
  const Whole turn = cross(g, e);
  const auto within_slack = [&](const Point& edge) {
    return (turn << slack_.shift) <= slack_.numerator * dot(edge, edge);
  };
  return sign(dot(e, g)) > 0 && within_slack(e) && within_slack(g);
}

/// Returns a side, the sides in line before it, then the sides in line after it.
std::vector<PartSide> ExactPairRule::sides_in_line(const PartSide& side) const {
  std::vector<PartSide> all = {side};
  for (PartSide last = side, next = side_before(last); in_line(next, last);
       last = next, next = side_before(next))
    all.push_back(next);
  for (PartSide last = side, next = side_after(last); in_line(last, next);
       last = next, next = side_after(next))
    all.push_back(next);
  return all;
}

Candidate ExactPairRule::candidate_on(const PartCorner& corner,
                                      const PartSide& side) const {
  const Line e = line(side);
  const Point& point = at(corner);
  Candidate found;
  found.corner = number(corner), found.side = side;
  found.depth = lattice_.rounded(e.depth(point));
  found.inside = sign(e.area2(point)) > 0;
  const Whole l2 = e.length2(), foot = dot(point - e.start, e.along);
  const Whole slack = slack_.numerator * l2;
  found.between =
      (foot << slack_.shift) >= -slack && ((l2 - foot) << slack_.shift) >= -slack;
  return found;
}

/// Tests a corner on the first side that has it between its ends: a side, or an edge in
/// line with it. If there is none, tests it on the side itself, which may have no end.
Candidate ExactPairRule::candidate(const Pair& pair, const PartCorner& corner,
                                   const PartSide& side, bool may_have_no_end,
                                   bool may_be_far) const {
  const std::vector<PartSide> sides = sides_in_line(side);
  const auto below = std::find_if(sides.begin(), sides.end(), [&](const PartSide& one) {
    return (one == side || !one.inner) && candidate_on(corner, one).between;
  });
  Candidate found = candidate_on(corner, below == sides.end() ? side : *below);
  if (found.side.inner)
    return found;
  found.far = may_be_far && far_bound(pair, corner, found.side).has_value();
  if (!found.between && found.inside && may_have_no_end)
    find_end(pair, corner, found);
  found.acts = found.inside && (found.between || found.no_end) && !found.far;
  return found;
}

/// Looks for a notch or a joint beyond the end of the side.
void ExactPairRule::find_end(const Pair& pair, const PartCorner& corner,
                             Candidate& found) const {
  const int own = found.side.part;
  const ShapeAxis axis{shape_[own], found.side.index, shape_[corner.part], corner.index,
                       std::nullopt};
  for (const int third : pair.thirds_of(own)) {
    if (is_in_notch(axis, shape_[third]))
      found.no_end = NoEnd::notch;
    else if (is_at_joint(axis, shape_[third], pair.shift))
      found.no_end = NoEnd::joint;
    if (found.no_end) {
      found.third = third;
      return;
    }
  }
}

/// Returns the candidates for contacts along an axis. Along the least axis, none is
/// far.
std::vector<Candidate> ExactPairRule::candidates(const Pair& pair, const Axis& axis,
                                                 bool is_least) const {
  const PartSide& e = axis.side;
  if (!axis.facing)
    return {candidate(pair, axis.deepest, e, true, !is_least)};
  const PartSide& f = *axis.facing;
  std::vector<Candidate> all;
  const auto add = [&](const PartSide& ends, const PartSide& on) {
    for (const PartCorner& corner : {start_of(ends), end_of(ends)})
      if (const Candidate found = candidate(pair, corner, on, false, !is_least);
          std::none_of(all.begin(), all.end(), [&](const Candidate& other) {
            return other.corner == found.corner && other.side == found.side;
          }))
        all.push_back(found);
  };
  for (const PartSide& side : sides_in_line(f))
    add(side, e);
  for (const PartSide& side : sides_in_line(e))
    if (!side.inner)
      add(side, f);
  return all;
}

}  // namespace blocks::audit
