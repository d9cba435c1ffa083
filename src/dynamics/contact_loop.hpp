// One step of all contacts: decide, find what touches, hand over, act (rules 7, 9-12).
// A template over the rules of the decision; contact_forces.cpp compiles it for every
// run, src/study for its variants.
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
    share.lanes_complete &= groups.set_lane(blocks, contacts, g + 1);
  };
  for (int h = g; h <= g + group.reentrant; ++h)
    if (groups.lane_of[h] >= 0)
      groups.store_lane(contacts, groups.lane_of[h]);
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
  share.lanes_complete &= groups.set_lane(blocks, contacts, g);
}

/// Decides the groups whose blocks have moved too far since they were last decided, of
/// the pairs first .. last - 1.
template <class Rules>
void renew_decisions(const Blocks& blocks, Contacts& contacts, ContactGroups& groups,
                     int first, int last, ContactGroups::Share& share) {
  for (int p = first; p < last; ++p) {
    PairWatch& watch = groups.watch[p];
    const double way = groups.swing.way[watch.low] + groups.swing.way[watch.high];
    if (Rules::keeps_decisions && way < watch.limit)
      continue;
    ContactPair& pair = groups.pairs[p];
    if (Rules::keeps_decisions) {
      const double left = pair.certain - relative_motion(blocks, groups.swing, pair.low,
                                                         pair.high, pair.pose);
      // the other way round a NaN would let a decision stand
      if (left > 0.0) {
        watch.limit = way + left;
        continue;
      }
    }
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
    watch.limit = way + pair.certain;
  }
}

/// Exactly what touches in the lanes of a set where that was left open, and which
/// springs have lost their contact.
template <class Rules>
void settle(const Blocks& blocks, ContactGroups& groups, int set,
            std::vector<LostForce>& lost) {
  ContactLanes& lanes = groups.lanes;
  const auto at = [&](int corner) { return Vec2(blocks.corner.col(corner)); };
  for (int i = set * lane_count; i < (set + 1) * lane_count; ++i) {
    if (lanes.rule[i] == by_sign && lanes.touch[i] != apart &&
        Rules::overlap_sign(at(lanes.corner[i]), at(lanes.edge[i]),
                            at(lanes.edge_end[i])) <= 0)
      lanes.touch[i] = apart;
    if (lanes.touch[i] != apart)
      continue;
    if (lanes.normal_elastic[i] > 0.0)
      lost.push_back({groups.group[i], groups.record[i], lanes.normal_elastic[i],
                      lanes.shear_elastic[i]});
    lanes.normal_elastic[i] = lanes.shear_elastic[i] = 0.0;
  }
}

inline BlockRows rows_of(const Blocks& blocks) {
  return {blocks.corner.data(),   blocks.arm.data(),  blocks.centroid.data(),
          blocks.velocity.data(), blocks.spin.data(), blocks.strain_rate.data()};
}

}  // namespace detail

/// evaluate_contacts (contact_forces.hpp) for any rules.
template <class Rules>
Extremes evaluate_contacts_by(const Blocks& blocks, Contacts& contacts,
                              ContactGroups& groups, const Settings& settings,
                              double dt, Workers& workers, Profile* profile = nullptr) {
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness,
                       settings.friction, dt};
  const int pairs = static_cast<int>(groups.pairs.size());
  {
    const Profile::Timer timer(profile, Profile::decisions);
    if (!groups.loaded)
      groups.load(blocks, contacts);
    workers.each(pairs, pairs_per_thread, [&](int part, int first, int last) {
      const detail::ExactCalls calls(profile, groups.shares[part]);
      detail::renew_decisions<Rules>(blocks, contacts, groups, first, last,
                                     groups.shares[part]);
    });
    groups.join_shares();
    if (!groups.lanes_complete)
      groups.list_lanes(blocks, contacts);
  }
  const Profile::Timer timer(profile, Profile::forces);
  const LaneArithmetic& arithmetic = lane_arithmetic();
  const BlockRows rows = detail::rows_of(blocks);
  const int sets = groups.lanes.sets();
  workers.each(sets, sets_per_thread, [&](int part, int first, int last) {
    const detail::ExactCalls calls(profile, groups.shares[part]);
    arithmetic.find_touching(groups.lanes, rows, first, last);
    for (int set = first; set < last; ++set)
      if (groups.lanes.look[set])
        detail::settle<Rules>(blocks, groups, set, groups.shares[part].lost);
  });
  groups.join_shares();
  if constexpr (Rules::hands_over)
    hand_over(blocks, contacts, groups, settings.normal_stiffness);
  groups.lost.clear();
  workers.each(sets, sets_per_thread, [&](int part, int first, int last) {
    const LaneExtremes most =
        arithmetic.act(groups.lanes, rows, law, settings.rigid, first, last);
    groups.shares[part].extremes.include(most.overlap, most.spring);
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
