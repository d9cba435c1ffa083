// The choice of docs/contact-rule.md#choice: which axis of two parts acts, and which
// contacts act along it.
#include <algorithm>

#include "audit/exact_pair_rule.hpp"

namespace blocks::audit {

/// Finds the closed joints that hide the axis and the surface that takes over.
void ExactPairRule::look_for_joints(PartDecision& decision, int index) const {
  Axis& axis = decision.axes[index];
  if (axis.joints_known)
    return;
  axis.joints_known = true;
  const auto axis_along = [&](const PartSide& side) {
    const auto found = std::find_if(decision.axes.begin(), decision.axes.end(),
                                    [&](const Axis& a) { return a.side == side; });
    return static_cast<int>(found - decision.axes.begin());
  };
  const auto collect = [&](HidingPlace place, const std::vector<Joint>& joints) {
    for (const Joint& joint : joints)
      axis.hidden_by.push_back({place, joint, axis_along(joint.surface)});
  };
  collect(HidingPlace::axis_side, closed_joints_of(axis.side, axis.corner_part));
  if (axis.facing)
    collect(HidingPlace::facing_side, closed_joints_of(*axis.facing, axis.side.part));
  const HiddenCorner corner = hidden({axis.corner_part, axis.corner_index}, axis.side);
  collect(HidingPlace::corner, corner.joints);
  axis.rise_keeps_it_visible = corner.rise_keeps_it_visible;
  if (axis.hidden_by.empty())
    return;
  const auto depth = [&](const HidingJoint& hiding) {
    return depth_of(decision.axes[hiding.surface]);
  };
  const HidingJoint& least =
      *std::min_element(axis.hidden_by.begin(), axis.hidden_by.end(),
                        [&](const HidingJoint& a, const HidingJoint& b) {
                          return compare(depth(a), depth(b)) < 0;
                        });
  axis.taken_over_by = least.surface;
  axis.taken_over_at = least.joint.corner;
}

void ExactPairRule::choose(PartDecision& decision) const {
  std::vector<Axis>& axes = decision.axes;
  const auto choose_axis = [&](Choice choice, int axis) {
    decision.choice = choice, decision.chosen = axis;
  };
  if (axes.front().depth_sign <= 0) {
    choose_axis(Choice::touching, 0);
    return find_contacts(decision);
  }
  const auto entered = std::find_if(axes.begin(), axes.end(), [&](Axis& axis) {
    axis.entry_known = true;
    axis.far = is_far(axis, {depth_of(axes.front()), {}});
    if (!axis.far)
      axis.entry = entry(axis);
    return axis.entry != Entry::none;
  });
  if (entered == axes.end()) {
    choose_axis(Choice::no_entry, 0);
    return test_corner(decision);
  }
  constexpr std::size_t most_looks = 3;
  decision.path = {static_cast<int>(entered - axes.begin())};
  for (;;) {
    look_for_joints(decision, decision.path.back());
    const int surface = axes[decision.path.back()].taken_over_by;
    if (surface < 0 || surface == decision.path.front())
      break;
    if (decision.path.size() == most_looks) {
      choose_axis(Choice::still_hidden, decision.path.front());
      return test_corner(decision);
    }
    decision.path.push_back(surface);
  }
  const bool is_entered = decision.path.size() == 1;
  choose_axis(is_entered ? Choice::entered : Choice::surface, decision.path.back());
  find_contacts(decision);
  if (is_entered && std::none_of(decision.candidates.begin(), decision.candidates.end(),
                                 [](const Candidate& c) { return c.acts; })) {
    if (entered->side.inner) {
      choose_axis(Choice::inner_side, -1);
      return;
    }
    choose_axis(Choice::no_contact, 0);
    test_corner(decision);
  }
}

/// Returns whether the next side is in line with a side: the far corner of each is at
/// most the slack below the other side.
bool ExactPairRule::in_line(const PartSide& side, const PartSide& next) const {
  const Point e = along(side), g = along(next);
  const Whole turn = cross(g, e);
  const auto within_slack = [&](const Point& edge) {
    return (turn << slack_.shift) <= slack_.numerator * dot(edge, edge);
  };
  return sign(dot(e, g)) > 0 && within_slack(e) && within_slack(g);
}

/// Returns a side, the sides in line before it, then the sides in line after it.
std::vector<PartSide> ExactPairRule::sides_in_line(const PartSide& side) const {
  std::vector<PartSide> all = {side};
  for (PartSide last = side, next = side_before(start_of(side)); in_line(next, last);
       last = next, next = side_before(start_of(next)))
    all.push_back(next);
  for (PartSide last = side, next = side_after(end_of(side)); in_line(last, next);
       last = next, next = side_after(end_of(next)))
    all.push_back(next);
  return all;
}

Candidate ExactPairRule::candidate_on(const PartCorner& corner,
                                      const PartSide& side) const {
  Candidate found;
  found.corner = number(corner), found.side = side;
  const Whole area = area2(at(corner), side), l2 = length2(side);
  found.depth = rounded(Depth{area, l2});
  found.inside = sign(area) > 0;
  const Whole foot = dot(at(corner) - corner_[side.start], along(side));
  const Whole slack = slack_.numerator * l2;
  found.between =
      (foot << slack_.shift) >= -slack && ((l2 - foot) << slack_.shift) >= -slack;
  found.edge = !side.inner;
  return found;
}

/// Tests a corner on the first side that has it between its ends: a side, or one in
/// line with it. If there is none, tests it on the first of these sides that has it in
/// a notch, if that is allowed, and otherwise on the side itself.
Candidate ExactPairRule::candidate(const PartCorner& corner, const PartSide& side,
                                   bool may_be_in_notch, const Region& region) const {
  const auto judged = [&](Candidate found) {
    const bool acts = found.inside && found.edge && (found.between || found.in_notch);
    found.far = acts && is_far({area2(at(corner), found.side), length2(found.side)},
                               region, found.side.part, corner.part);
    found.acts = acts && !found.far;
    return found;
  };
  const std::vector<PartSide> sides = sides_in_line(side);
  for (const PartSide& one : sides)
    if (const Candidate found = candidate_on(corner, one); found.between)
      return judged(found);
  if (may_be_in_notch)
    for (const PartSide& one : sides)
      if (Candidate found = candidate_on(corner, one);
          found.inside && found.edge && is_in_notch(corner, one)) {
        found.in_notch = true;
        return judged(found);
      }
  return candidate_on(corner, side);
}

/// Returns what bounds the depth of contacts along the chosen axis. If surfaces have
/// taken over, the corners of their joints are added.
ExactPairRule::Region ExactPairRule::region_of(const PartDecision& decision) const {
  Region region{depth_of(decision.axes.front()), {}};
  if (decision.choice == Choice::surface)
    for (std::size_t i = 0; i + 1 < decision.path.size(); ++i)
      region.joints.push_back(decision.axes[decision.path[i]].taken_over_at);
  return region;
}

/// Tests the corner of the chosen axis on the axis side. No other contact can act.
void ExactPairRule::test_corner(PartDecision& decision) const {
  const Axis& axis = decision.axes[decision.chosen];
  decision.candidates.push_back(candidate({axis.corner_part, axis.corner_index},
                                          axis.side, !axis.facing,
                                          region_of(decision)));
}

/// Finds the candidates for contacts along the chosen axis.
void ExactPairRule::find_contacts(PartDecision& decision) const {
  const Axis& axis = decision.axes[decision.chosen];
  if (!axis.facing)
    return test_corner(decision);
  const PartSide& e = axis.side;
  const PartSide& f = *axis.facing;
  const Region region = region_of(decision);
  const auto add = [&](const PartSide& ends, const PartSide& on) {
    for (const PartCorner& corner : {start_of(ends), end_of(ends)})
      if (const Candidate found = candidate(corner, on, false, region); std::none_of(
              decision.candidates.begin(), decision.candidates.end(),
              [&](const Candidate& other) {
                return other.corner == found.corner && other.side == found.side;
              }))
        decision.candidates.push_back(found);
  };
  for (const PartSide& side : sides_in_line(f))
    add(side, e);
  for (const PartSide& side : sides_in_line(e))
    if (!side.inner)
      add(side, f);
}

PartDecision ExactPairRule::decide_parts(int part, int other) const {
  PartDecision decision;
  decision.part = part, decision.other = other;
  decision.axes = axes(part, other);
  for (const Axis& axis : decision.axes) {
    const Depth d = depth_of(axis);
    if ((d.area2 << slack_.shift) < -(slack_.numerator * d.length2)) {
      decision.choice = Choice::apart;
      decision.separating = axis.side;
      decision.separation = axis.depth;
      return decision;
    }
  }
  choose(decision);
  return decision;
}

}  // namespace blocks::audit
