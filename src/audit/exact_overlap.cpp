// The overlap region, far contacts and notches of docs/contact-rule.md, in exact
// fractions.
#include <algorithm>

#include "audit/exact_pair_rule.hpp"
#include "geometry/contact_constants.hpp"

namespace blocks::audit {
namespace {

/// A point in units of the lattice.
struct RatioPoint {
  Ratio x, y;
};

Ratio square(const Ratio& x) { return x * x; }

Ratio squared_distance(const RatioPoint& p, const RatioPoint& q) {
  return square(q.x - p.x) + square(q.y - p.y);
}

Ratio exact(const Dyadic& constant) {
  return Ratio(constant.numerator) / Ratio(Whole(1) << constant.shift);
}

}  // namespace

/// Tests d > factor D + eps L in squares, and likewise for the depth of the least axis.
/// Both sides are multiplied by L first, so that the left side becomes 2A - eps L^2. A
/// segment of the region that is long enough by itself answers the question without the
/// distances between all vertices.
bool ExactPairRule::is_far(const Depth& depth, const Region& region, int part,
                           int other) const {
  const Whole scaled_excess =
      (depth.area2 << slack_.shift) - slack_.numerator * depth.length2;
  if (sign(scaled_excess) <= 0)
    return false;
  const Depth& least = region.least;
  const Dyadic factor(geometry::far_factor);
  const Whole in_factors = scaled_excess << factor.shift,
              of_least = (factor.numerator * least.area2) << slack_.shift;
  if (sign(of_least) > 0 &&
      in_factors * in_factors * least.length2 <= of_least * of_least * depth.length2)
    return false;
  const Ratio excess = Ratio(scaled_excess) / Ratio(Whole(1) << slack_.shift);
  // The square of a diameter that explains the depth.
  const Ratio wanted = square(excess / exact(factor)) / Ratio(depth.length2);
  std::vector<RatioPoint> vertices;
  for (const auto& [mine, yours] : {std::pair(part, other), std::pair(other, part)})
    for (int i = 0; i < size(mine); ++i) {
      const PartSide s = side(mine, i);
      const Stretch segment = part_inside(s, yours);
      if (segment.empty())
        continue;
      if (square(segment.length()) * Ratio(length2(s)) >= wanted)
        return false;
      const Point start = corner_[s.start], e = along(s);
      for (const Ratio& place : {segment.begin, segment.end})
        vertices.push_back(
            {Ratio(start.x) + place * Ratio(e.x), Ratio(start.y) + place * Ratio(e.y)});
    }
  if (vertices.empty())
    return false;
  for (const int joint : region.joints)
    vertices.push_back({Ratio(corner_[joint].x), Ratio(corner_[joint].y)});
  for (const RatioPoint& p : vertices)
    for (const RatioPoint& q : vertices)
      if (squared_distance(p, q) >= wanted)
        return false;
  return true;
}

bool ExactPairRule::is_far(const Axis& axis, const Region& region) const {
  const auto end_is_far = [&](int corner) {
    return is_far({area2(corner_[corner], axis.side), length2(axis.side)}, region,
                  axis.side.part, axis.corner_part);
  };
  if (!axis.facing)
    return end_is_far(axis.corner);
  return end_is_far(axis.facing->start) && end_is_far(axis.facing->end);
}

bool ExactPairRule::is_in_notch(const PartCorner& corner, const PartSide& s) const {
  const Point start = corner_[s.start], e = along(s), c = at(corner);
  const Whole l2 = length2(s), foot = dot(c - start, e);
  const Whole beyond = sign(foot) < 0 ? Whole(-foot) : Whole(foot - l2);
  const Dyadic slope(geometry::notch_slope);
  // The slope times the distance beyond the end is at most the depth.
  if (sign(beyond) <= 0 || slope.numerator * beyond > (area2(c, s) << slope.shift))
    return false;
  if (part_inside(s, corner.part).empty())
    return false;
  const Ratio place = Ratio(foot) / Ratio(l2),
              rise = exact(slope) * Ratio(beyond) / Ratio(l2);
  const RatioPoint raised = {Ratio(start.x) + place * Ratio(e.x) - rise * Ratio(e.y),
                             Ratio(start.y) + place * Ratio(e.y) + rise * Ratio(e.x)};
  const auto is_inside = [&](int part) {
    for (int i = 0; i < size(part); ++i) {
      const PartSide border = side(part, i);
      const Point &from = corner_[border.start], way = along(border);
      if ((raised.x - Ratio(from.x)) * Ratio(way.y) <=
          (raised.y - Ratio(from.y)) * Ratio(way.x))
        return false;
    }
    return true;
  };
  const int own = parts_[s.part].block;
  for (int part = first_part_[own]; part < first_part_[own + 1]; ++part)
    if (part != s.part && is_inside(part))
      return true;
  for (const int block : neighbours_[parts_[corner.part].block])
    for (int part = first_part_[block]; block != own && part < first_part_[block + 1];
         ++part)
      if (boxes_meet(part, corner.part) && is_inside(part))
        return true;
  return false;
}

}  // namespace blocks::audit
