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
#include "dynamics/contact_lanes.hpp"
#include "dynamics/profile.hpp"
#include "dynamics/workers.hpp"

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
inline void release(Contacts& contacts, std::vector<LostForce>& lost, int g, int i) {
  if (contacts.normal_elastic[i] > 0.0)
    lost.push_back({g, i, contacts.normal_elastic[i], contacts.shear_elastic[i]});
  contacts.active[i] = 0;
  contacts.normal_elastic[i] = contacts.shear_elastic[i] = 0.0;
  contacts.normal_force[i] = contacts.shear_force[i] = 0.0;
  contacts.overlap[i] = 0.0;
}

/// Counts what this thread leaves to exact arithmetic during its life.
class ExactCalls {
 public:
  ExactCalls(const Profile* profile, ContactGroups::Share& share)
      : share_(profile != nullptr ? &share : nullptr),
        before_(share_ != nullptr ? geometry::exact::calls() : 0) {}
  ~ExactCalls() {
    if (share_ != nullptr)
      share_->exact_calls += geometry::exact::calls() - before_;
  }
  ExactCalls(const ExactCalls&) = delete;
  ExactCalls& operator=(const ExactCalls&) = delete;

 private:
  ContactGroups::Share* share_;
  unsigned long long before_;
};

/// Which record of group g acts, or which two of a notch, and for how long that is
/// known.
template <class Rules>
void decide(const Blocks& blocks, Contacts& contacts, ContactGroups& groups, int g,
            ContactGroups::Share& share) {
  ContactGroup& group = groups.all[g];
  const auto release_but = [&](int one, int other) {
    for (int i = group.first; i < group.last; ++i)
      if (contacts.active[i] && i != one && i != other)
        release(contacts, share.lost, g, i);
  };
  const auto set_notch = [&](int record) {
    groups.all[g + 1].acting = record;
    share.live_complete &= groups.set_live(blocks, contacts, g + 1);
  };
  group.certain = {};
  if (Rules::keeps_decisions && group.hopeless == 0) {
    group.certain = certainty(blocks, contacts, group);
    group.pose =
        relative_pose(blocks, groups.swing, group.corner_block, group.edge_block);
  }
  if (group.certain.travel > 0.0) {
    release_but(group.certain.candidate, -1);
    if (group.reentrant)
      set_notch(-1);
  } else {
    group.hopeless = group.hopeless == 0 ? 16 : group.hopeless - 1;
    const ContactDecision<Rules> decision(blocks, contacts, groups);
    group.acting = decision.acting_record(group);
    const int other = decision.notch_record(group, group.acting);
    release_but(group.acting, other);
    if (group.reentrant)
      set_notch(other);
  }
  share.live_complete &= groups.set_live(blocks, contacts, g);
}

/// Decides the groups whose blocks have moved too far since they were last decided, of
/// the pairs first .. last - 1.
template <class Rules>
void renew_decisions(const Blocks& blocks, Contacts& contacts, ContactGroups& groups,
                     int first, int last, ContactGroups::Share& share) {
  for (int p = first; p < last; ++p) {
    ContactPair& pair = groups.pairs[p];
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
        decide<Rules>(blocks, contacts, groups, g, share);
      pair.certain = std::min(pair.certain, left());
    }
  }
}

/// a. Frame of the edge, overlap, and whether the contact acts, of the live contacts
/// begin .. end - 1.
template <class Rules>
void measure(const Blocks& blocks, Contacts& contacts, ContactGroups& groups, int begin,
             int end, std::vector<LostForce>& lost) {
  const ContactLanes& lanes = contact_lanes();
  const double* const corner = blocks.corner.data();
  LiveContact* const all = groups.live.data();
  OverlapLanes l;
  for (int first = begin; first < end; first += lane_count) {
    const int used = std::min(lane_count, end - first);
    for (int k = 0; k < lane_count; ++k) {
      const LiveContact& live = all[first + (k < used ? k : 0)];
      const double *c = corner + 2 * live.corner, *p1 = corner + 2 * live.edge;
      const double* const p2 = corner + 2 * live.edge_end;
      l.xc[k] = c[0], l.yc[k] = c[1];
      l.x1[k] = p1[0], l.y1[k] = p1[1];
      l.x2[k] = p2[0], l.y2[k] = p2[1];
    }
    lanes.overlaps(l);
    for (int k = 0; k < used; ++k) {
      LiveContact& live = all[first + k];
      live.tangent_x = l.tangent_x[k], live.tangent_y = l.tangent_y[k];
      live.overlap = l.overlap[k];
      if (!live.by_sign || live.record < 0)
        continue;
      live.acts = l.value[k] > l.bound[k];
      if (!live.acts && !(l.value[k] < -l.bound[k]))
        live.acts = Rules::overlap_sign({l.xc[k], l.yc[k]}, {l.x1[k], l.y1[k]},
                                        {l.x2[k], l.y2[k]}) > 0;
      if (!live.acts && contacts.active[live.record])
        release(contacts, lost, live.group, live.record);
    }
  }
}

/// b.-d. for up to lane_count acting contacts.
inline void load(const Blocks& blocks, const Contacts& contacts,
                 const LiveContact* const* acting, bool rigid, ForceLanes& l) {
  const double *const arm = blocks.arm.data(), *const corner = blocks.corner.data();
  const double* const centroid = blocks.centroid.data();
  const double* const velocity = blocks.velocity.data();
  const double* const spin = blocks.spin.data();
  const double* const damping = contacts.damping.data();
  const double* const normal = contacts.normal_elastic.data();
  const double* const shear = contacts.shear_elastic.data();
  const char* const active = contacts.active.data();
  for (int k = 0; k < lane_count; ++k) {
    const LiveContact& live = *acting[k];
    const int i = live.record, c = live.corner;
    const int a = live.corner_block, b = live.edge_block;
    l.tangent_x[k] = live.tangent_x, l.tangent_y[k] = live.tangent_y;
    l.overlap[k] = live.overlap;
    l.arm_ax[k] = arm[2 * c], l.arm_ay[k] = arm[2 * c + 1];
    l.arm_bx[k] = corner[2 * c] - centroid[2 * b];
    l.arm_by[k] = corner[2 * c + 1] - centroid[2 * b + 1];
    l.vax[k] = velocity[2 * a], l.vay[k] = velocity[2 * a + 1];
    l.vbx[k] = velocity[2 * b], l.vby[k] = velocity[2 * b + 1];
    l.spin_a[k] = spin[a], l.spin_b[k] = spin[b];
    l.damping[k] = damping[i];
    l.starting[k] = active[i] ? 0.0 : 1.0;
    l.normal_elastic[k] = normal[i], l.shear_elastic[k] = shear[i];
  }
  if (rigid)
    return;
  const double* const rate = blocks.strain_rate.data();
  for (int k = 0; k < lane_count; ++k)
    for (int r = 0; r < 4; ++r) {
      l.rate_a[r][k] = rate[4 * acting[k]->corner_block + r];
      l.rate_b[r][k] = rate[4 * acting[k]->edge_block + r];
    }
}

inline void store(const ForceLanes& l, int used, const LiveContact* const* acting,
                  Contacts& contacts, PairForce* pair_force, Extremes& extremes) {
  double* const normal_elastic = contacts.normal_elastic.data();
  double* const shear_elastic = contacts.shear_elastic.data();
  double* const normal_force = contacts.normal_force.data();
  double* const shear_force = contacts.shear_force.data();
  double* const overlap = contacts.overlap.data();
  char* const active = contacts.active.data();
  for (int k = 0; k < used; ++k) {
    const LiveContact& live = *acting[k];
    const int i = live.record;
    active[i] = 1;
    normal_elastic[i] = l.normal_elastic[k], shear_elastic[i] = l.shear_elastic[k];
    normal_force[i] = l.normal_force[k], shear_force[i] = l.shear_force[k];
    overlap[i] = live.overlap;
    extremes.include(live.overlap, l.normal_elastic[k]);
    const int side = live.corner_is_low ? 0 : 1;
    PairForce& a = pair_force[2 * live.pair + side];
    PairForce& b = pair_force[2 * live.pair + 1 - side];
    a.x += l.fx[k], a.y += l.fy[k], a.moment += l.moment_a[k];
    b.x -= l.fx[k], b.y -= l.fy[k], b.moment += l.moment_b[k];
    for (int r = 0; r < 4; ++r)
      a.sums[r] += l.sums_a[r][k], b.sums[r] += l.sums_b[r][k];
  }
}

/// b.-e. for all contacts of the pairs first .. last - 1 that act.
inline Extremes act(const Blocks& blocks, Contacts& contacts, ContactGroups& groups,
                    const ContactLaw& law, bool rigid, int first, int last) {
  const ContactLanes& lanes = contact_lanes();
  std::fill(groups.pair_force.begin() + 2 * first, groups.pair_force.begin() + 2 * last,
            PairForce{});
  Extremes extremes;
  ForceLanes l;
  const LiveContact* acting[lane_count];
  int used = 0;
  const auto finish = [&] {
    std::fill(acting + used, acting + lane_count, acting[0]);  // of no account
    load(blocks, contacts, acting, rigid, l);
    lanes.forces(l, law, rigid);
    store(l, used, acting, contacts, groups.pair_force.data(), extremes);
    used = 0;
  };
  const auto of_pair = [&](int pair) {
    return std::lower_bound(
        groups.live.begin(), groups.live.end(), pair,
        [](const LiveContact& live, int p) { return live.pair < p; });
  };
  const auto end = of_pair(last);
  for (auto live = of_pair(first); live != end; ++live) {
    acting[used] = &*live;
    used += live->acts;
    if (used == lane_count)
      finish();
  }
  if (used > 0)
    finish();
  return extremes;
}

/// Sums what the pairs of each block do to it, in the order of the list.
inline void gather(Blocks& blocks, const ContactGroups& groups, int first, int last) {
  for (int b = first; b < last; ++b) {
    PairForce sum;
    for (int k = groups.first_of_block[b]; k < groups.first_of_block[b + 1]; ++k) {
      const PairForce& f = groups.pair_force[groups.by_block[k]];
      sum.x += f.x, sum.y += f.y, sum.moment += f.moment;
      for (int r = 0; r < 4; ++r)
        sum.sums[r] += f.sums[r];
    }
    blocks.force(0, b) += sum.x, blocks.force(1, b) += sum.y;
    blocks.moment[b] += sum.moment;
    for (int r = 0; r < 4; ++r)
      blocks.applied(r, b) += sum.sums[r];
  }
}

}  // namespace detail

/// add_contact_forces (contact_forces.hpp) for any rules.
template <class Rules>
Extremes add_contact_forces_by(Blocks& blocks, Contacts& contacts,
                               ContactGroups& groups, const Settings& settings,
                               double dt, Workers& workers,
                               Profile* profile = nullptr) {
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness,
                       settings.friction, dt};
  const int pairs = static_cast<int>(groups.pairs.size());
  {
    const Profile::Timer timer(profile, Profile::decisions);
    workers.each(pairs, pairs_per_thread, [&](int part, int first, int last) {
      const detail::ExactCalls calls(profile, groups.shares[part]);
      detail::renew_decisions<Rules>(blocks, contacts, groups, first, last,
                                     groups.shares[part]);
    });
    groups.join_shares();
    if (!groups.live_complete)
      groups.list_live(blocks, contacts);
  }
  const Profile::Timer timer(profile, Profile::forces);
  const int live = static_cast<int>(groups.live.size());
  workers.each(live, live_per_thread, [&](int part, int first, int last) {
    const detail::ExactCalls calls(profile, groups.shares[part]);
    detail::measure<Rules>(blocks, contacts, groups, first, last,
                           groups.shares[part].lost);
  });
  groups.join_shares();
  if constexpr (Rules::hands_over)
    hand_over(blocks, contacts, groups, settings.normal_stiffness);
  groups.lost.clear();
  workers.each(pairs, pairs_per_thread, [&](int part, int first, int last) {
    groups.shares[part].extremes =
        detail::act(blocks, contacts, groups, law, settings.rigid, first, last);
  });
  workers.each(blocks.size(), blocks_per_thread, [&](int, int first, int last) {
    detail::gather(blocks, groups, first, last);
  });
  Extremes extremes;
  for (ContactGroups::Share& share : groups.shares) {
    extremes.include(share.extremes.overlap, share.extremes.spring);
    share.extremes = {};
    if (profile != nullptr)
      profile->exact_calls += share.exact_calls;
    share.exact_calls = 0;
  }
  return extremes;
}

}  // namespace blocks::dynamics
