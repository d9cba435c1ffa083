// Finds the axes of two parts and which of them are entered (docs/contact-rule.md). The
// choice of the axis that acts is in exact_choice.cpp, closed joints are in
// exact_covered_side.cpp.
#include "audit/exact_pair_rule.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/contact_constants.hpp"

namespace blocks::audit {
namespace {

/// Returns the mean of the corners, summed in order, in doubles.
Vec2 mean_of_corners(const Blocks& blocks, const ConvexPart& part) {
  Vec2 sum = Vec2::Zero();
  for (const int c : part.corners)
    sum += blocks.corner.col(c);
  return sum / static_cast<double>(part.corners.size());
}

}  // namespace

ExactPairRule::ExactPairRule(const Blocks& blocks, std::vector<ConvexPart> parts,
                             std::vector<std::vector<int>> neighbours,
                             const std::vector<int>& order)
    : blocks_(blocks), parts_(std::move(parts)), neighbours_(std::move(neighbours)),
      rank_(static_cast<std::size_t>(blocks.size())), slack_(geometry::contact_slack) {
  for (int i = 0; i < blocks.size(); ++i)
    rank_[order.empty() ? i : order[i]] = i;
  if (!order.empty())
    for (std::vector<int>& some : neighbours_)
      std::sort(some.begin(), some.end(),
                [&](int a, int b) { return rank_[a] < rank_[b]; });
  first_part_.assign(static_cast<std::size_t>(blocks.size()) + 1, 0);
  for (const ConvexPart& part : parts_)
    ++first_part_[static_cast<std::size_t>(part.block) + 1];
  for (std::size_t b = 1; b < first_part_.size(); ++b)
    first_part_[b] += first_part_[b - 1];
  std::vector<Vec2> centroids;
  for (const ConvexPart& part : parts_)
    centroids.push_back(blocks.convex[part.block]
                            ? Vec2(blocks.centroid.col(part.block))
                            : mean_of_corners(blocks, part));
  for (const double x : blocks.corner.reshaped())
    lattice_.include(x);
  for (const Vec2& centroid : centroids)
    for (const double x : centroid)
      lattice_.include(x);
  for (int c = 0; c < blocks.corners(); ++c)
    corner_.push_back(lattice_(Vec2(blocks.corner.col(c))));
  for (const Vec2& centroid : centroids)
    centroid_.push_back(lattice_(centroid));
}

PartSide ExactPairRule::side(int part, int index) const {
  const std::vector<int>& corners = parts_[part].corners;
  const int n = size(part), i = index % n;
  PartSide side{part, i, corners[i], corners[(i + 1) % n], false};
  side.inner = blocks_.next[side.start] != side.end;
  return side;
}

/// Returns the sign of a - b, where a and b are depths 2A / L.
int ExactPairRule::compare(const Depth& a, const Depth& b) {
  if (sign(a.area2) != sign(b.area2))
    return sign(a.area2) > sign(b.area2) ? 1 : -1;
  return sign(a.area2) *
         (a.area2 * a.area2 * b.length2).compare(b.area2 * b.area2 * a.length2);
}

double ExactPairRule::rounded(const Depth& depth) const {
  return lattice_.rounded(depth.area2, 2) /
         std::sqrt(lattice_.rounded(depth.length2, 2));
}

double ExactPairRule::overlap(int corner, int edge) const {
  const Point e = corner_[blocks_.next[edge]] - corner_[edge];
  return rounded(Depth{cross(corner_[corner] - corner_[edge], e), dot(e, e)});
}

double ExactPairRule::length(const PartSide& side) const {
  return std::sqrt(lattice_.rounded(length2(side), 2));
}

ExactPairRule::Depth ExactPairRule::depth_of(const Axis& axis) const {
  return {area2(corner_[axis.corner], axis.side), length2(axis.side)};
}

/// Two sides face if they run against each other within ten degrees. Let D be the cross
/// product of both, Q the product of their squared lengths and s = |D| / sqrt(Q) the
/// sine. The condition is s <= sin 10. Below 30 degrees this holds if the sine of the
/// triple angle, 3 s - 4 s^3, is at most 1/2. Squared, it is
/// 4 D^2 (3 Q - 4 D^2)^2 <= Q^3.
bool ExactPairRule::face(const PartSide& one, const PartSide& other) const {
  const Point e = along(one), f = along(other);
  if (sign(dot(e, f)) >= 0)
    return false;
  const Whole d = cross(e, f), d2 = d * d, q = dot(e, e) * dot(f, f);
  if (4 * d2 >= q)
    return false;
  const Whole rest = 3 * q - 4 * d2;
  return 4 * d2 * rest * rest <= q * q * q;
}

std::optional<PartSide> ExactPairRule::facing_side(const Axis& axis) const {
  const PartCorner corner{axis.corner_part, axis.corner_index};
  const PartSide before = side_before(corner), after = side_after(corner);
  const bool one = face(before, axis.side), two = face(after, axis.side);
  if (one && two) {
    const Point e = along(axis.side);
    const Whole d1 = cross(along(before), e), d2 = cross(along(after), e);
    return d2 * d2 * length2(before) < d1 * d1 * length2(after) ? after : before;
  }
  if (one || two)
    return one ? before : after;
  return std::nullopt;
}

/// Equally deep corners follow each other. If the side belongs to the part with the
/// lower number, the last of them clockwise counts, otherwise the first one.
Axis ExactPairRule::axis_of(const PartSide& side, int other) const {
  Axis axis;
  axis.side = side, axis.corner_part = other;
  const int count = size(other);
  std::vector<Whole> depths;
  for (int i = 0; i < count; ++i)
    depths.push_back(area2(at({other, i}), side));
  const auto most = std::max_element(depths.begin(), depths.end());
  const Whole deepest = *most;
  int& index = axis.corner_index;
  index = static_cast<int>(most - depths.begin());
  const bool is_first = rank_[parts_[side.part].block] < rank_[parts_[other].block];
  const int step = is_first ? 1 : count - 1;
  for (int k = 1; k < count && depths[(index + step) % count] == deepest; ++k)
    index = (index + step) % count;
  axis.corner = number({other, axis.corner_index});
  axis.depth = rounded(Depth{deepest, length2(side)});
  axis.depth_sign = sign(deepest);
  axis.facing = facing_side(axis);
  return axis;
}

/// Returns all axes of two parts, the least first.
std::vector<Axis> ExactPairRule::axes(int part, int other) const {
  std::vector<Axis> all;
  const bool in_order = rank_[parts_[part].block] < rank_[parts_[other].block];
  const int first = in_order ? part : other, second = in_order ? other : part;
  for (const auto& [mine, yours] : {std::pair(first, second), std::pair(second, first)})
    for (int i = 0; i < size(mine); ++i)
      all.push_back(axis_of(side(mine, i), yours));
  std::stable_sort(all.begin(), all.end(), [&](const Axis& a, const Axis& b) {
    return compare(depth_of(a), depth_of(b)) < 0;
  });
  return all;
}

/// Returns whether a point is outside an edge of the part.
bool ExactPairRule::is_outside_part(const Point& point, int part) const {
  for (int i = 0; i < size(part); ++i)
    if (const PartSide s = side(part, i); !s.inner && outside(point, s))
      return true;
  return false;
}

Entry ExactPairRule::entry(const Axis& axis) const {
  if (axis.depth_sign <= 0)
    return Entry::none;
  const int part = axis.side.part;
  std::vector<PartSide> others;  // other sides that have the corner outside
  for (int i = 0; i < size(part); ++i)
    if (const PartSide s = side(part, i);
        i != axis.side.index && outside(corner_[axis.corner], s))
      others.push_back(s);
  if (others.empty())
    return Entry::inside;
  if (!axis.facing)
    return Entry::none;
  const Point& other_end = axis.facing->start == axis.corner
                               ? corner_[axis.facing->end]
                               : corner_[axis.facing->start];
  bool is_inside = true;
  for (int i = 0; i < size(part); ++i)
    is_inside = is_inside && sign(area2(other_end, side(part, i))) > 0;
  if (is_inside)
    return Entry::other_end;
  const Whole foot =
      dot(corner_[axis.corner] - corner_[axis.side.start], along(axis.side));
  const Whole l2 = length2(axis.side), slack = slack_.numerator * l2;
  if ((foot << slack_.shift) < slack || ((l2 - foot) << slack_.shift) < slack)
    return Entry::foot;
  if (others.size() > 1 || others.front().inner)
    return Entry::none;
  const PartCorner start = start_of(axis.side), end = end_of(axis.side);
  const bool crossing =
      (others.front() == side_before(start) &&
       is_outside_part(at(start), axis.corner_part)) ||
      (others.front() == side_after(end) && is_outside_part(at(end), axis.corner_part));
  return crossing ? Entry::crossing : Entry::none;
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
