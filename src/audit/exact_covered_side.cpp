// The closed joints, covered sides and hidden corners of docs/contact-rule.md, in exact
// fractions.
#include <algorithm>
#include <cmath>

#include "audit/exact_pair_rule.hpp"
#include "geometry/contact_constants.hpp"

namespace blocks::audit {
namespace {

Ratio ratio(const Whole& n, const Whole& d) { return Ratio(n) / Ratio(d); }

}  // namespace

/// Returns the joint at a corner of a part and whether it is closed against part
/// `against`. `side`, the side of the joint, is one of the two sides that meet at the
/// corner.
Joint ExactPairRule::joint(const PartCorner& corner, const PartSide& side,
                           int against) const {
  Joint found;
  const bool from_start = start_of(side).index == corner.index;
  found.corner = number(corner);
  found.side = side;
  found.surface = from_start ? side_before(corner) : side_after(corner);
  found.against_part = against;
  found.surface_inner = found.surface.inner;
  if (found.surface_inner)
    return found;
  found.centroid_below = sign(area2(centroid_[against], found.surface)) > 0;
  if (found.centroid_below)
    return found;
  if (side.inner) {
    found.closed = found.cover.covered = true;
    found.cover.side = same_side_beyond(side);
    return found;
  }
  found.cover = cover(side, from_start, against);
  found.closed = found.cover.covered;
  return found;
}

/// Returns the closed joints at the start and at the end of the side.
std::vector<Joint> ExactPairRule::closed_joints_of(const PartSide& side,
                                                   int against) const {
  std::vector<Joint> found;
  for (const PartCorner& corner : {start_of(side), end_of(side)})
    if (const Joint one = joint(corner, side, against); one.closed)
      found.push_back(one);
  return found;
}

/// Returns whether the outline of the block turns inwards at the corner.
bool ExactPairRule::is_re_entrant(int corner) const {
  const Point& before = corner_[blocks_.previous[corner]];
  return sign(cross(corner_[blocks_.next[corner]] - before, corner_[corner] - before)) <
         0;
}

/// Returns the joints at the corner that hide it from a side of another part. The joint
/// whose covered side starts in the corner comes first.
HiddenCorner ExactPairRule::hidden(const PartCorner& corner,
                                   const PartSide& from) const {
  HiddenCorner found;
  for (const PartSide& g : {side_after(corner), side_before(corner)}) {
    const Joint here = joint(corner, g, from.part);
    if (!here.closed)
      continue;
    const int sigma = number(end_of(here.surface)) == here.corner ? 1 : -1;
    const auto turns_away = [&](const PartSide& w) {
      return sigma * sign(cross(along(w), along(from))) > 0 && !face(from, w);
    };
    if (!turns_away(here.surface))
      continue;
    if (g.inner && is_re_entrant(here.corner))
      continue;
    if (here.cover.side) {
      const PartSide& f = *here.cover.side;
      const PartSide beyond =
          sigma > 0 ? side_after(end_of(f)) : side_before(start_of(f));
      if (sigma * sign(cross(along(here.surface), along(beyond))) < 0) {
        found.rises = true;
        if (!turns_away(beyond)) {
          found.rise_keeps_it_visible = true;
          continue;
        }
      }
    }
    found.joints.push_back(here);
  }
  return found;
}

/// Returns the inner side as a side of the part beside it, or nothing if that part has
/// no area.
std::optional<PartSide> ExactPairRule::same_side_beyond(const PartSide& inner) const {
  const int block = parts_[inner.part].block;
  for (int part = first_part_[block]; part < first_part_[block + 1]; ++part)
    for (int i = 0; i < size(part); ++i)
      if (const PartSide s = side(part, i);
          s.start == inner.end && s.end == inner.start)
        return s;
  return std::nullopt;
}

/// Returns whether the bounding boxes of two parts meet, borders included. They do
/// unless one part is wholly beyond the other along an axis.
bool ExactPairRule::boxes_meet(int part, int other) const {
  const auto all_below = [&](int low, int high, Whole Point::*along) {
    for (int i = 0; i < size(low); ++i)
      for (int k = 0; k < size(high); ++k)
        if (!(at({low, i}).*along < at({high, k}).*along))
          return false;
    return true;
  };
  for (Whole Point::*along : {&Point::x, &Point::y})
    if (all_below(part, other, along) || all_below(other, part, along))
      return false;
  return true;
}

/// Returns the interval of side g that lies in a convex part, borders included.
ExactPairRule::Stretch ExactPairRule::part_inside(const PartSide& g, int part) const {
  Stretch inside{0, 1};
  for (int i = 0; i < size(part); ++i) {
    const PartSide border = side(part, i);
    const Whole from = area2(corner_[g.start], border),
                to = area2(corner_[g.end], border);
    if (sign(from) < 0 && sign(to) < 0)
      return {};
    if (sign(from) >= 0 && sign(to) >= 0)
      continue;
    const Ratio crossing = ratio(from, from - to);
    if (sign(from) < 0)
      inside.begin = std::max(inside.begin, crossing);
    else
      inside.end = std::min(inside.end, crossing);
  }
  return inside;
}

/// Returns the projection of side f on the line of side g.
ExactPairRule::Stretch ExactPairRule::projection(const PartSide& f,
                                                 const PartSide& g) const {
  const auto foot = [&](int c) {
    return ratio(dot(corner_[c] - corner_[g.start], along(g)), length2(g));
  };
  const Ratio a = foot(f.start), b = foot(f.end);
  return {std::min(a, b), std::max(a, b)};
}

/// Returns whether two parts touch along f and g: no axis of the two parts is less deep
/// than both that of f and that of g.
bool ExactPairRule::touch_along(const PartSide& f, const PartSide& g) const {
  const Depth of_f = depth_of(axis_of(f, g.part)), of_g = depth_of(axis_of(g, f.part));
  const auto is_less = [&](const Axis& axis) {
    const Depth d = depth_of(axis);
    return compare(d, of_f) < 0 && compare(d, of_g) < 0;
  };
  for (int i = 0; i < size(f.part); ++i)
    if (is_less(axis_of(side(f.part, i), g.part)))
      return false;
  for (int i = 0; i < size(g.part); ++i)
    if (is_less(axis_of(side(g.part, i), f.part)))
      return false;
  return true;
}

/// Returns the gap between f and g as a fraction of the length of g. It is measured at
/// right angles to g at the position `middle` on g. It is negative where the two
/// overlap.
Ratio ExactPairRule::gap(const PartSide& f, const PartSide& g,
                         const Ratio& middle) const {
  const Whole l2 = length2(g);
  const Point from = corner_[f.start] - corner_[g.start], f_along = along(f);
  // u is the position on f whose foot on g is `middle`.
  const Ratio u =
      (middle * Ratio(l2) - Ratio(dot(from, along(g)))) / Ratio(dot(f_along, along(g)));
  const Ratio depth =
      Ratio(cross(from, along(g))) + u * Ratio(cross(f_along, along(g)));
  return -depth / Ratio(l2);
}

/// Returns whether some corner of the part is at least `stretch` times the length of g
/// below f.
bool ExactPairRule::reaches_below(const PartSide& f, int part, const PartSide& g,
                                  const Ratio& stretch) const {
  const Ratio least = stretch * stretch * Ratio(length2(g)) * Ratio(length2(f));
  for (int i = 0; i < size(part); ++i)
    if (const Whole area = area2(at({part, i}), f);
        sign(area) >= 0 && Ratio(area * area) >= least)
      return true;
  return false;
}

/// Finds how much of side g the neighbours of part `against` cover. The stretch begins
/// at the start of g if `from_start`, otherwise at its end.
Cover ExactPairRule::cover(const PartSide& g, bool from_start, int against) const {
  Cover found;
  const Stretch interval = part_inside(g, against);
  if (interval.empty())
    return found;
  const Stretch stretch =
      from_start ? Stretch{0, interval.end} : Stretch{interval.begin, 1};
  const Ratio h = stretch.length();  // as a fraction of the length of g
  const auto common = [](const Stretch& a, const Stretch& b) {
    return Stretch{std::max(a.begin, b.begin), std::min(a.end, b.end)};
  };
  Ratio of_stretch = 0, of_interval = 0, longest = 0;
  for (const int block : neighbours_[parts_[against].block]) {
    if (block == parts_[g.part].block)
      continue;
    for (int t = first_part_[block]; t < first_part_[block + 1]; ++t)
      for (int i = 0; boxes_meet(t, against) && i < size(t); ++i) {
        const PartSide f = side(t, i);
        if (!face(f, g))
          continue;
        const Stretch covered = common(projection(f, g), stretch);
        if (covered.empty() || !touch_along(f, g))
          continue;
        const Ratio apart = gap(f, g, (covered.begin + covered.end) / 2);
        const bool overlap = apart <= 0 && -apart <= h;
        if (apart > h || !reaches_below(f, against, g, h) ||
            (part_inside(f, against).empty() && !overlap))
          continue;
        of_stretch += covered.length();
        of_interval += common(covered, interval).length();
        if (covered.length() > longest)
          longest = covered.length(), found.side = f;
      }
  }
  const Ratio least(geometry::covered_share);
  found.covered = of_stretch >= least * stretch.length() &&
                  of_interval >= least * interval.length();
  const double l = length(g);
  found.stretch = static_cast<double>(h) * l;
  found.interval = static_cast<double>(interval.length()) * l;
  found.share_of_stretch = static_cast<double>(Ratio(of_stretch / h));
  found.share_of_interval = static_cast<double>(Ratio(of_interval / interval.length()));
  return found;
}

}  // namespace blocks::audit
