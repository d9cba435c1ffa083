// One step of all contacts: decide, measure, hand over, act (rules 7, 9-12). A template
// over the rules of the decision; contact_forces.cpp compiles it for every run,
// src/study for its variants.
#pragma once

#include <algorithm>
#include <cmath>

#include "dynamics/applied_force.hpp"
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

inline void release(Contacts& contacts, int i) {
  contacts.active[i] = 0;
  contacts.normal_elastic[i] = contacts.shear_elastic[i] = 0.0;
  contacts.normal_force[i] = contacts.shear_force[i] = 0.0;
  contacts.overlap[i] = 0.0;
}

/// Which record of group g acts, or which two, and for how long that is certain.
template <class Rules>
void decide(const Blocks& blocks, Contacts& contacts, ContactGroups& groups, int g) {
  ContactGroup& group = groups.all[g];
  const ContactDecision<Rules> decision(blocks, contacts, groups);
  group.acting = decision.acting_record(group);
  int other = -1;
  if (group.reentrant)
    other = groups.all[g + 1].acting = decision.notch_record(group, group.acting);
  for (int i = group.first; i < group.last; ++i)
    if (i != group.acting && i != other && contacts.active[i]) {
      if (contacts.normal_elastic[i] > 0.0)
        groups.lost.push_back(
            {g, i, contacts.normal_elastic[i], contacts.shear_elastic[i]});
      release(contacts, i);
    }
  if constexpr (!Rules::keeps_decisions)
    return;
  if (group.hopeless > 0) {
    --group.hopeless;
    return;
  }
  group.certain = certain_travel(blocks, contacts, group);
  mark_position(blocks, groups.swing, group);
  if (group.certain == 0.0)
    group.hopeless = 16;
}

/// a. Frame of the acting edge and overlap.
inline void measure(const Blocks& blocks, const Contacts& contacts,
                    ContactGroup& group) {
  const int c = contacts.corner[group.acting], e = contacts.edge[group.acting];
  const int e2 = blocks.next[e];
  const double x1 = blocks.corner(0, e), y1 = blocks.corner(1, e);
  const double ex = blocks.corner(0, e2) - x1, ey = blocks.corner(1, e2) - y1;
  const double wx = blocks.corner(0, c) - x1, wy = blocks.corner(1, c) - y1;
  const double length = std::sqrt(ex * ex + ey * ey);
  group.tangent_x = ex / length;
  group.tangent_y = ey / length;
  // its sign was decided exactly; rounded, a tiny depth may come out below zero
  group.overlap = std::max(0.0, (wx * ey - wy * ex) / length);
}

inline void act(Blocks& blocks, Contacts& contacts, const ContactGroup& group,
                const ContactLaw& law) {
  const int i = group.acting, c = contacts.corner[i];
  const int a = group.corner_block, b = group.edge_block;
  const double tx = group.tangent_x, ty = group.tangent_y;
  const double nx = -ty, ny = tx, overlap = group.overlap;
  const double x = blocks.corner(0, c), y = blocks.corner(1, c);

  // Relative velocity of the two material points. In plain numbers: vectors would go
  // through memory here.
  const Vec2 arm_a(blocks.arm(0, c), blocks.arm(1, c));
  const Vec2 arm_b(x - blocks.centroid(0, b), y - blocks.centroid(1, b));
  const Vec2 va = point_velocity(blocks, a, arm_a),
             vb = point_velocity(blocks, b, arm_b);
  const double vx = va.x() - vb.x(), vy = va.y() - vb.y();

  // b.-d.
  ElasticForce spring{contacts.normal_elastic[i], contacts.shear_elastic[i]};
  const ContactForce force = apply(law, spring, -(vx * nx + vy * ny), vx * tx + vy * ty,
                                   overlap, contacts.damping[i], !contacts.active[i]);
  contacts.active[i] = 1;
  contacts.normal_elastic[i] = spring.normal;
  contacts.shear_elastic[i] = spring.shear;
  contacts.normal_force[i] = force.normal;
  contacts.shear_force[i] = force.shear;
  contacts.overlap[i] = overlap;

  // e. Equal and opposite at one point.
  const double fx = force.normal * nx - force.shear * tx;
  const double fy = force.normal * ny - force.shear * ty;
  add_force(blocks, a, arm_a, {fx, fy});
  add_force(blocks, b, arm_b, {-fx, -fy});
}

}  // namespace detail

/// add_contact_forces (contact_forces.hpp) for any rules.
template <class Rules>
Extremes add_contact_forces_by(Blocks& blocks, Contacts& contacts,
                               ContactGroups& groups, const Settings& settings,
                               double dt) {
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness,
                       settings.friction, dt};
  for (int g = 0; g < static_cast<int>(groups.all.size()); ++g) {
    ContactGroup& group = groups.all[g];
    // the other way round a NaN would let a decision stand
    if (!group.of_notch &&  // decided with the one before
        (!Rules::keeps_decisions ||
         !(relative_motion(blocks, groups.swing, group) < group.certain)))
      detail::decide<Rules>(blocks, contacts, groups, g);
    if (group.acting >= 0)
      detail::measure(blocks, contacts, group);
  }
  if constexpr (Rules::hands_over)
    hand_over(blocks, contacts, groups, settings.normal_stiffness);
  groups.lost.clear();
  // apart from the forces, whose branches would wait for each root and quotient
  Extremes extremes;
  for (const ContactGroup& group : groups.all)
    if (group.acting >= 0) {
      detail::act(blocks, contacts, group, law);
      extremes.include(group.overlap, contacts.normal_elastic[group.acting]);
    }
  return extremes;
}

}  // namespace blocks::dynamics
