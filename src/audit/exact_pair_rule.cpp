// Finds the axis of two parts that acts (docs/contact-rule.md). Its contacts are found
// in exact_contacts.cpp.
#include "audit/exact_pair_rule.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/contact_constants.hpp"

namespace blocks::audit {

bool Axis::hidden() const {
  return std::any_of(blocking.begin(), blocking.end(),
                     [](const Blocking& one) { return one.hides; });
}

ExactPairRule::ExactPairRule(const Blocks& blocks, std::vector<ConvexPart> parts,
                             std::vector<std::vector<int>> neighbours,
                             const std::vector<int>& order)
    : blocks_(blocks), parts_(std::move(parts)), neighbours_(std::move(neighbours)),
      rank_(static_cast<std::size_t>(blocks.size())), slack_(geometry::contact_slack) {
  for (int i = 0; i < blocks.size(); ++i)
    rank_[order.empty() ? i : order[i]] = i;
  first_part_.assign(static_cast<std::size_t>(blocks.size()) + 1, 0);
  for (const ConvexPart& part : parts_)
    ++first_part_[static_cast<std::size_t>(part.block) + 1];
  for (std::size_t b = 1; b < first_part_.size(); ++b)
    first_part_[b] += first_part_[b - 1];
  for (const double x : blocks.corner.reshaped())
    lattice_.include(x);
  for (const ConvexPart& part : parts_) {
    shape_.emplace_back();
    for (const int c : part.corners)
      shape_.back().push_back(lattice_(Vec2(blocks.corner.col(c))));
  }
}

PartSide ExactPairRule::side(int part, int index) const {
  const std::vector<int>& corners = parts_[part].corners;
  const int n = size(part), i = index % n;
  PartSide side{part, i, corners[i], corners[(i + 1) % n], false};
  side.inner = blocks_.next[side.start] != side.end;
  return side;
}

double ExactPairRule::overlap(int corner, int edge) const {
  const auto point = [&](int c) { return lattice_(Vec2(blocks_.corner.col(c))); };
  const Point start = point(edge);
  return lattice_.rounded(
      Line{start, point(blocks_.next[edge]) - start}.depth(point(corner)));
}

ShapeAxis ExactPairRule::shapes_of(const Axis& axis) const {
  return {shape_[axis.side.part], axis.side.index, shape_[axis.deepest.part],
          axis.deepest.index,
          axis.facing ? std::optional(axis.facing->index) : std::nullopt};
}

/// Two sides face if they run against each other within ten degrees. Let D be the cross
/// product of both, Q the product of their squared lengths and s = |D| / sqrt(Q) the
/// sine. The condition is s <= sin 10. Below 30 degrees this holds if the sine of the
/// triple angle, 3 s - 4 s^3, is at most 1/2. Squared, it is
/// 4 D^2 (3 Q - 4 D^2)^2 <= Q^3.
bool ExactPairRule::face(const PartSide& one, const PartSide& other) const {
  const Point e = line(one).along, f = line(other).along;
  if (sign(dot(e, f)) >= 0)
    return false;
  const Whole d = cross(e, f), d2 = d * d, q = dot(e, e) * dot(f, f);
  if (4 * d2 >= q)
    return false;
  const Whole rest = 3 * q - 4 * d2;
  return 4 * d2 * rest * rest <= q * q * q;
}

std::optional<PartSide> ExactPairRule::facing_side(const Axis& axis) const {
  const PartSide after = side(axis.deepest.part, axis.deepest.index),
                 before = side_before(after);
  const bool one = face(before, axis.side), two = face(after, axis.side);
  if (one && two) {
    const auto sine = [&](const PartSide& f) {  // times the length of the axis side
      const Whole turn = cross(line(f).along, line(axis.side).along);
      return Length{abs(turn), line(f).length2()};
    };
    return sine(after) < sine(before) ? after : before;
  }
  if (one || two)
    return one ? before : after;
  return std::nullopt;
}

/// Equally deep corners follow each other. If the side belongs to the part with the
/// lower number, the last of them clockwise counts, otherwise the first one.
Axis ExactPairRule::axis_of(const PartSide& side, int other) const {
  const Line e = line(side);
  const int count = size(other);
  std::vector<Whole> depths;
  depths.reserve(shape_[other].size());
  for (const Point& point : shape_[other])
    depths.push_back(e.area2(point));
  const auto max = std::max_element(depths.begin(), depths.end());
  int index = static_cast<int>(max - depths.begin());
  const bool is_first = rank_[parts_[side.part].block] < rank_[parts_[other].block];
  const int step = is_first ? 1 : count - 1;
  for (int k = 1; k < count && depths[(index + step) % count] == *max; ++k)
    index = (index + step) % count;
  Axis axis;
  axis.side = side;
  axis.deepest = {other, index};
  axis.corner = number(axis.deepest);
  axis.depth = lattice_.rounded(depth_of(axis));
  axis.depth_sign = sign(*max);
  axis.facing = facing_side(axis);
  return axis;
}

/// Returns all axes of two parts, the least first.
std::vector<Axis> ExactPairRule::axes(int part, int other) const {
  std::vector<std::pair<Length, Axis>> all;
  const bool in_order = rank_[parts_[part].block] < rank_[parts_[other].block];
  const int first = in_order ? part : other, second = in_order ? other : part;
  for (const auto& [mine, yours] : {std::pair(first, second), std::pair(second, first)})
    for (int i = 0; i < size(mine); ++i) {
      const Axis axis = axis_of(side(mine, i), yours);
      all.emplace_back(depth_of(axis), axis);
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Axis> found;
  for (const auto& [depth, axis] : all)
    found.push_back(axis);
  return found;
}

/// Returns whether the bounding box of a part meets that of another one, grown by a
/// part of the sum of its extents.
bool ExactPairRule::is_within_reach(int part, int other) const {
  using Span = std::pair<double, double>;
  const auto span = [&](int number, int axis) {
    Span found(INFINITY, -INFINITY);
    for (const int corner : parts_[number].corners) {
      found.first = std::min(found.first, blocks_.corner(axis, corner));
      found.second = std::max(found.second, blocks_.corner(axis, corner));
    }
    return found;
  };
  const Span x = span(other, 0), y = span(other, 1);
  const double reach =
      geometry::third_reach * ((x.second - x.first) + (y.second - y.first));
  const auto meets = [&](const Span& one, const Span& two) {
    return one.second >= two.first - reach && two.second + reach >= one.first;
  };
  return meets(span(part, 0), x) && meets(span(part, 1), y);
}

/// Returns the third parts of `own`: those that may continue it where it meets `other`.
std::vector<int> ExactPairRule::third_parts(int own, int other) const {
  std::vector<int> found;
  const auto add_parts_of = [&](int block) {
    for (int part = first_part_[block]; part < first_part_[block + 1]; ++part)
      if (part != own && is_within_reach(part, own) && is_within_reach(part, other))
        found.push_back(part);
  };
  const int own_block = parts_[own].block, other_block = parts_[other].block;
  add_parts_of(own_block);
  for (const int block : neighbours_[other_block])
    if (block != own_block)
      add_parts_of(block);
  return found;
}

/// Returns twice the largest bound if the corner exceeds all of them, or nothing if it
/// is not far.
std::optional<FarBound> ExactPairRule::far_bound(const Pair& pair,
                                                 const PartCorner& corner,
                                                 const PartSide& side) const {
  const Length depth = line(side).depth(at(corner));
  Bound which = Bound::separating_shift;
  Length largest{0, 1};
  const auto exceeds = [&](Bound bound, const Length& length) {
    const Length limit = Dyadic(geometry::deepest_share) * length;
    if (limit > largest)
      largest = limit, which = bound;
    return depth > largest;
  };
  if (!exceeds(Bound::separating_shift, pair.shift))
    return std::nullopt;
  for (const int own : pair.part)
    for (const int third : pair.thirds_of(own)) {
      const int other = own == pair.part[0] ? pair.part[1] : pair.part[0];
      if (!exceeds(Bound::third_part, separating_shift(shape_[other], shape_[third])))
        return std::nullopt;
    }
  const Length diameter = common_diameter(shape_[pair.part[0]], shape_[pair.part[1]]);
  if (sign(diameter.n) == 0 || !exceeds(Bound::common_diameter, diameter))
    return std::nullopt;
  return FarBound{which, lattice_.rounded(largest)};
}

/// An axis with a facing side is far if both ends of that side are.
std::optional<FarBound> ExactPairRule::far_bound(const Pair& pair,
                                                 const Axis& axis) const {
  if (!axis.facing)
    return far_bound(pair, axis.deepest, axis.side);
  if (!far_bound(pair, start_of(*axis.facing), axis.side))
    return std::nullopt;
  return far_bound(pair, end_of(*axis.facing), axis.side);
}

/// Returns the first third part that carries one of the two (step 4), or -1.
int ExactPairRule::find_carrier(const Pair& pair, const Axis& least_axis) const {
  for (const int own : pair.part)
    for (const int third : pair.thirds_of(own)) {
      const int other = own == pair.part[0] ? pair.part[1] : pair.part[0];
      if (pair.shift > Dyadic(geometry::deepest_share) *
                           separating_shift(shape_[other], shape_[third]))
        continue;
      const ThirdOf whose = own == least_axis.side.part ? ThirdOf::own : ThirdOf::other;
      const auto obstacle = find_obstacle(shapes_of(least_axis), shape_[third], whose);
      if (!obstacle || !obstacle->hides)
        continue;
      const PartDecision decision = find_axis(third, other);
      if (!is_doubtful(decision) && !is_doubtful(find_axis(third, own)) &&
          std::any_of(decision.candidates.begin(), decision.candidates.end(),
                      [](const Candidate& one) { return one.acts; }))
        return third;
    }
  return -1;
}

/// Returns the third parts that block the shift out of the axis, up to the first one
/// that hides it.
std::vector<Blocking> ExactPairRule::blocking(const Pair& pair,
                                              const Axis& axis) const {
  std::vector<Blocking> found;
  const double length = lattice_.rounded(line(axis.side).length());
  for (const ThirdOf whose : {ThirdOf::own, ThirdOf::other})
    for (const int third :
         pair.thirds_of(whose == ThirdOf::own ? axis.side.part : axis.deepest.part))
      if (const auto one = find_obstacle(shapes_of(axis), shape_[third], whose)) {
        const auto in_length = [&](const Obstacle::Slide& slide) {
          return Blocking::Slide{length * rounded(slide.length),
                                 length * rounded(slide.rest)};
        };
        found.push_back({third, whose, lattice_.rounded(one->overlap),
                         in_length(one->shorter), in_length(one->longer), one->hides});
        if (one->hides)
          return found;
      }
  return found;
}

/// Determines whether an axis is skipped, far or hidden. The axis of least depth is
/// never far.
void ExactPairRule::examine(const Pair& pair, Axis& axis, bool is_least) const {
  axis.examined = true;
  if (!is_least && axis.facing && !crosses(line(*axis.facing), shape_[axis.side.part]))
    axis.facing.reset();
  axis.skipped = axis.side.inner;
  if (!axis.skipped && !is_least)
    axis.far = far_bound(pair, axis);
  if (!axis.skipped && !axis.far)
    axis.blocking = blocking(pair, axis);
}

PartDecision ExactPairRule::decide_parts(int part, int other) const {
  PartDecision decision = find_axis(part, other);
  if (!is_doubtful(decision))
    return decision;
  const Axis& least_axis = decision.axes.front();
  const Pair pair = pair_of(part, other, depth_of(least_axis));
  decision.carrier = find_carrier(pair, least_axis);
  if (decision.carrier >= 0) {
    decision.choice = Choice::none;
    decision.candidates.clear();
  } else if (decision.choice == Choice::none) {
    decision.choice = Choice::least_axis, decision.chosen = 0;
    decision.candidates = candidates(pair, least_axis, true);
  }
  return decision;
}

/// Returns whether a pair may be left to a third part: no axis is left, or the acting
/// axis is not the least one, although the least one is not deeper than the slack.
bool ExactPairRule::is_doubtful(const PartDecision& decision) const {
  if (decision.choice == Choice::none)
    return true;
  if (decision.chosen <= 0)
    return false;
  const Axis& least_axis = decision.axes.front();
  return !(depth_of(least_axis) > slack_ * line(least_axis.side).length());
}

ExactPairRule::Pair ExactPairRule::pair_of(int part, int other,
                                           const Length& shift) const {
  return {{part, other}, {third_parts(part, other), third_parts(other, part)}, shift};
}

/// Decides two parts, but if no axis is left, nothing acts.
PartDecision ExactPairRule::find_axis(int part, int other) const {
  PartDecision decision;
  decision.part = part, decision.other = other;
  decision.axes = axes(part, other);
  std::vector<Axis>& axes = decision.axes;
  for (const Axis& axis : axes)
    if (depth_of(axis) < -(slack_ * line(axis.side).length())) {
      decision.separating = axis.side;
      decision.separation = axis.depth;
      return decision;
    }
  const Pair pair = pair_of(part, other, depth_of(axes.front()));
  decision.choice = Choice::none;
  if (axes.front().depth_sign <= 0)
    decision.choice = Choice::touching, decision.chosen = 0;
  for (std::size_t i = 0; i < axes.size() && decision.chosen < 0; ++i) {
    examine(pair, axes[i], i == 0);
    if (!axes[i].skipped && !axes[i].far && !axes[i].hidden())
      decision.choice = Choice::axis, decision.chosen = static_cast<int>(i);
  }
  if (decision.chosen >= 0)
    decision.candidates = candidates(pair, axes[decision.chosen], decision.chosen == 0);
  return decision;
}

PairDecision ExactPairRule::decide(int a, int b) const {
  PairDecision decision;
  for (int i = first_part_[a]; i < first_part_[a + 1]; ++i)
    for (int j = first_part_[b]; j < first_part_[b + 1]; ++j) {
      decision.parts.push_back(decide_parts(i, j));
      for (const Candidate& found : decision.parts.back().candidates)
        if (found.acts)
          decision.contacts.emplace_back(found.corner, found.side.start);
    }
  auto& contacts = decision.contacts;
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  return decision;
}

}  // namespace blocks::audit
