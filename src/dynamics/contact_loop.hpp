// One step of all contacts: decide, measure, hand over, act (rules 7, 9-12). A template
// over the rules of the decision; contact_forces.cpp compiles it for every run,
// src/study for its variants.
#pragma once

#include <algorithm>
#include <cmath>

#include "dynamics/contact_certainty.hpp"
#include "dynamics/contact_decision.hpp"
#include "dynamics/contact_forces.hpp"
#include "dynamics/contact_handover.hpp"
#include "dynamics/contact_law.hpp"

namespace blocks::dynamics {
namespace detail {

/// Velocity of the material point of block b at `arm` from its centroid; strain rates
/// included, zero for a rigid block (14).
inline Vec2 point_velocity(const Blocks& blocks, int b, const Vec2& arm) {
  const auto rate = blocks.strain_rate.col(b);
  const double spin = blocks.spin[b];
  return {blocks.velocity(0, b) + rate[0] * arm.x() + (rate[1] - spin) * arm.y(),
          blocks.velocity(1, b) + (rate[2] + spin) * arm.x() + rate[3] * arm.y()};
}

/// Record i of group g acts no more: its forces are gone, its spring may find an heir.
inline void release(Contacts& contacts, ContactGroups& groups, int g, int i) {
  if (contacts.normal_elastic[i] > 0.0)
    groups.lost.push_back(
        {g, i, contacts.normal_elastic[i], contacts.shear_elastic[i]});
  contacts.active[i] = 0;
  contacts.normal_elastic[i] = contacts.shear_elastic[i] = 0.0;
  contacts.normal_force[i] = contacts.shear_force[i] = 0.0;
  contacts.overlap[i] = 0.0;
}

/// Which record of group g acts, or which two of a notch, and for how long that is
/// known.
template <class Rules>
void decide(const Blocks& blocks, Contacts& contacts, ContactGroups& groups, int g) {
  ContactGroup& group = groups.all[g];
  const ContactDecision<Rules> decision(blocks, contacts, groups);
  const int before = group.acting, candidate = group.certain.candidate;
  const bool by_sign = group.certain.travel > 0.0;
  group.acting = decision.acting_record(group);
  int other = -1;
  if (group.reentrant) {
    other = decision.notch_record(group, group.acting);
    groups.live_current = groups.live_current && groups.all[g + 1].acting == other;
    groups.all[g + 1].acting = other;
  }
  for (int i = group.first; i < group.last; ++i)
    if (contacts.active[i] && i != group.acting && i != other)
      release(contacts, groups, g, i);

  group.certain = {};
  if (Rules::keeps_decisions && group.hopeless == 0) {
    group.certain = certainty(blocks, contacts, group);
    group.pose =
        relative_pose(blocks, groups.swing, group.corner_block, group.edge_block);
    group.hopeless = group.certain.travel == 0.0 ? 16 : 0;
  } else if (group.hopeless > 0) {
    --group.hopeless;
  }
  const bool same =
      by_sign == (group.certain.travel > 0.0) &&
      (by_sign ? candidate == group.certain.candidate : before == group.acting);
  groups.live_current = groups.live_current && same;
}

/// Decides the groups whose blocks have moved too far since they were last decided.
template <class Rules>
void renew_decisions(const Blocks& blocks, Contacts& contacts, ContactGroups& groups) {
  for (ContactPair& pair : groups.pairs) {
    // the other way round a NaN would let a decision stand
    if (Rules::keeps_decisions && relative_motion(blocks, groups.swing, pair.low,
                                                  pair.high, pair.pose) < pair.certain)
      continue;
    pair.certain = std::numeric_limits<double>::max();
    pair.pose = relative_pose(blocks, groups.swing, pair.low, pair.high);
    for (int g = pair.first; g < pair.last; ++g) {
      ContactGroup& group = groups.all[g];
      if (group.of_notch)  // with the one before
        continue;
      const auto left = [&] {
        return group.certain.travel - relative_motion(blocks, groups.swing,
                                                      group.corner_block,
                                                      group.edge_block, group.pose);
      };
      if (!Rules::keeps_decisions || !(left() > 0.0))
        decide<Rules>(blocks, contacts, groups, g);
      pair.certain = std::min(pair.certain, left());
    }
  }
}

/// a. Frame of the edge, overlap, and whether the contact acts.
template <class Rules>
void measure(const Blocks& blocks, Contacts& contacts, ContactGroups& groups) {
  for (LiveContact& live : groups.live) {
    const int c = live.corner, e1 = live.edge, e2 = live.edge_end;
    const double x1 = blocks.corner(0, e1), y1 = blocks.corner(1, e1);
    const double x2 = blocks.corner(0, e2), y2 = blocks.corner(1, e2);
    const double xc = blocks.corner(0, c), yc = blocks.corner(1, c);
    if (live.by_sign) {
      live.acts = Rules::overlap_sign({xc, yc}, {x1, y1}, {x2, y2}) > 0;
      if (!live.acts) {
        if (contacts.active[live.record])
          release(contacts, groups, live.group, live.record);
        continue;
      }
    }
    const double ex = x2 - x1, ey = y2 - y1, wx = xc - x1, wy = yc - y1;
    const double length = std::sqrt(ex * ex + ey * ey);
    live.tangent_x = ex / length;
    live.tangent_y = ey / length;
    // its sign was decided exactly; rounded, a tiny depth may come out below zero
    live.overlap = std::max(0.0, (wx * ey - wy * ex) / length);
  }
}

/// A force on the block whose centroid is at -arm.
inline void add(PairForce& sum, const Vec2& arm, double fx, double fy) {
  const double x = arm.x(), y = arm.y();
  sum.x += fx, sum.y += fy, sum.moment += x * fy - y * fx;
  sum.xx += fx * x, sum.xy += fx * y, sum.yx += fy * x, sum.yy += fy * y;
}

inline void act(const Blocks& blocks, Contacts& contacts, ContactGroups& groups,
                const LiveContact& live, const ContactLaw& law) {
  const int i = live.record, c = live.corner;
  const int a = contacts.corner_block[i], b = contacts.edge_block[i];
  const double tx = live.tangent_x, ty = live.tangent_y, nx = -ty, ny = tx;

  // Relative velocity of the two material points.
  const Vec2 arm_a(blocks.arm(0, c), blocks.arm(1, c));
  const Vec2 arm_b(blocks.corner(0, c) - blocks.centroid(0, b),
                   blocks.corner(1, c) - blocks.centroid(1, b));
  const Vec2 va = point_velocity(blocks, a, arm_a),
             vb = point_velocity(blocks, b, arm_b);
  const double vx = va.x() - vb.x(), vy = va.y() - vb.y();

  // b.-d.
  ElasticForce spring{contacts.normal_elastic[i], contacts.shear_elastic[i]};
  const ContactForce force =
      apply(law, spring, -(vx * nx + vy * ny), vx * tx + vy * ty, live.overlap,
            contacts.damping[i], !contacts.active[i]);
  contacts.active[i] = 1;
  contacts.normal_elastic[i] = spring.normal;
  contacts.shear_elastic[i] = spring.shear;
  contacts.normal_force[i] = force.normal;
  contacts.shear_force[i] = force.shear;
  contacts.overlap[i] = live.overlap;

  // e. Equal and opposite at one point.
  const double fx = force.normal * nx - force.shear * tx;
  const double fy = force.normal * ny - force.shear * ty;
  const int side = a == groups.pairs[live.pair].low ? 0 : 1;
  add(groups.pair_force[2 * live.pair + side], arm_a, fx, fy);
  add(groups.pair_force[2 * live.pair + 1 - side], arm_b, -fx, -fy);
}

/// Sums what the pairs of each block do to it, in the order of the list.
inline void gather(Blocks& blocks, const ContactGroups& groups) {
  for (int b = 0; b < blocks.size(); ++b) {
    PairForce sum;
    for (int k = groups.first_of_block[b]; k < groups.first_of_block[b + 1]; ++k) {
      const PairForce& f = groups.pair_force[groups.by_block[k]];
      sum.x += f.x, sum.y += f.y, sum.moment += f.moment;
      sum.xx += f.xx, sum.xy += f.xy, sum.yx += f.yx, sum.yy += f.yy;
    }
    blocks.force(0, b) += sum.x, blocks.force(1, b) += sum.y;
    blocks.moment[b] += sum.moment;
    blocks.applied(0, b) += sum.xx, blocks.applied(1, b) += sum.xy;
    blocks.applied(2, b) += sum.yx, blocks.applied(3, b) += sum.yy;
  }
}

}  // namespace detail

/// add_contact_forces (contact_forces.hpp) for any rules.
template <class Rules>
Extremes add_contact_forces_by(Blocks& blocks, Contacts& contacts,
                               ContactGroups& groups, const Settings& settings,
                               double dt) {
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness,
                       settings.friction, dt};
  detail::renew_decisions<Rules>(blocks, contacts, groups);
  if (!groups.live_current)
    groups.list_live(blocks, contacts);
  detail::measure<Rules>(blocks, contacts, groups);
  if constexpr (Rules::hands_over)
    hand_over(blocks, contacts, groups, settings.normal_stiffness);
  groups.lost.clear();
  std::fill(groups.pair_force.begin(), groups.pair_force.end(), PairForce{});
  // apart from the forces, whose branches would wait for each root and quotient
  Extremes extremes;
  for (const LiveContact& live : groups.live)
    if (live.acts) {
      detail::act(blocks, contacts, groups, live, law);
      extremes.include(live.overlap, contacts.normal_elastic[live.record]);
    }
  detail::gather(blocks, groups);
  return extremes;
}

}  // namespace blocks::dynamics
