// One step of all contacts: decide, act where they touch, hand over (rules 7, 9-12).
// A template over the rules of the decision; contact_forces.cpp compiles it for every
// run, src/study for its variants.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "dynamics/contact_certainty.hpp"
#include "dynamics/contact_decision.hpp"
#include "dynamics/contact_forces.hpp"
#include "dynamics/contact_handover.hpp"
#include "dynamics/contact_lanes.hpp"
#include "dynamics/decided_records.hpp"
#include "dynamics/profile.hpp"
#include "dynamics/third_travel.hpp"
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

/// A certainty that would not outlive so many steps costs more than the decisions that
/// it spares; for so many decisions no other is tried.
inline constexpr int least_life = 3;
inline constexpr unsigned decisions_between = ContactGroup::most_hopeless;
/// One that outlives so many is not put on a condition to live longer.
inline constexpr int long_life = 32;

/// A condition that bounds keep for fewer steps, for the corner may pass an edge or
/// two, is prompt: these are asked exactly in each step, which takes less time than
/// bounds.
inline constexpr int prompt_life = 32;

/// Whether the condition of certain group g of the pair holds; moved: how far the
/// blocks have moved from the pair's pose. If it does, it need not be asked again
/// before they have moved by more than `unasked`, but for edges that are watched. Only
/// where the bounds do not tell it is asked exactly.
template <class Rules>
bool condition_holds(const Blocks& blocks, const Contacts& contacts,
                     const ContactDecision<Rules>& decision, ContactGroups& groups,
                     ContactPair& pair, int g, double moved, double motion) {
  ContactGroup& group = groups.all[g];
  const int block = pair.edge_block(group);
  const double enough = prompt_life * motion;
  const ConditionTravel found =
      condition_travel(blocks, contacts, group, block, enough);
  pair.prompt &= ~pair.bit(g);
  group.unasked = rounded_down(moved + found.travel);
  if (!(found.travel > 0.0) && !decision.stands(group, block))
    return false;
  if (found.travel < enough && found.rest > 4.0 * found.travel && pair.bit(g) != 0) {
    pair.prompt |= pair.bit(g);
    group.set(found.watch);
    group.unasked = rounded_down(moved + found.rest);
  }
  return true;
}

/// Which record of group g acts, or which two of a notch, and for how long that is
/// known from where the blocks stand.
template <class Rules>
void decide(const Blocks& blocks, const Contacts& contacts, ContactGroups& groups,
            int p, int g, double motion, ContactGroups::Share& share) {
  const ContactDecision<Rules> decision(blocks, contacts, groups);
  ContactPair& pair = groups.pairs[p];
  ContactGroup& group = groups.all[g];
  const int block = pair.edge_block(group);
  int other = -1;  // of a notch
  group.travel = 0.0F;
  if (Rules::keeps_decisions && group.hopeless == 0) {
    const Certainty known =
        certainty(blocks, contacts, groups, group, block, long_life * motion);
    if (known.travel > least_life * motion &&
        groups.watch_thirds(blocks, p, g, known.away))
      group.set(known);
    if (group.certain() && group.conditional() &&
        !condition_holds(blocks, contacts, decision, groups, pair, g, 0.0, motion)) {
      group.travel = 0.0F;
      groups.thirds.drop(p / pairs_of_window, g);
    }
  }
  if (!group.certain()) {
    group.hopeless = (group.hopeless == 0 ? decisions_between : group.hopeless - 1U) &
                     ContactGroup::most_hopeless;
    group.set_record(decision.acting_record(group, block));
    other = decision.notch_record(group, block, group.record());
  }
  seat_records(blocks, contacts, groups, g, other, share);
}

/// Decides the groups of a pair for which the blocks have moved too far, `moved` from
/// the pose of the pair. Where a certainty is looked for anew, all of the pair's count
/// from the present pose.
template <class Rules>
void renew_pair(const Blocks& blocks, const Contacts& contacts, ContactGroups& groups,
                int p, double moved, double dt, ContactGroups::Share& share) {
  ContactPair& pair = groups.pairs[p];
  const double motion = motion_of_step(blocks, groups.swing, pair.low, pair.high, dt);
  const ContactDecision<Rules> decision(blocks, contacts, groups);
  bool anew = false;
  // the other way round a NaN would let a decision stand
  const auto stands = [&](int g) {
    ContactGroup& group = groups.all[g];
    if (!Rules::keeps_decisions || !(group.travel - moved > 0.0))
      return false;
    if (!group.conditional() || group.unasked - moved > 0.0)
      return true;
    anew = true;
    return condition_holds(blocks, contacts, decision, groups, pair, g, moved, motion);
  };
  const int end = groups.end_of(p);
  for (int g = pair.first; g < end; ++g) {
    ContactGroup& group = groups.all[g];
    if (group.of_notch || stands(g))
      continue;
    group.travel = 0.0F;
    pair.prompt &= ~pair.bit(g);
    groups.thirds.drop(p / pairs_of_window, g);
    anew |= group.hopeless == 0;
  }
  float& certain = groups.poses[p].certain;
  certain = std::numeric_limits<float>::max();
  for (int g = pair.first; g < end; ++g) {
    ContactGroup& group = groups.all[g];
    if (group.of_notch)  // with the one before
      continue;
    if (!group.certain()) {
      decide<Rules>(blocks, contacts, groups, p, g, motion, share);
    } else if (anew) {
      group.travel = rounded_down(group.travel - moved);
      group.unasked = rounded_down(group.unasked - moved);
    }
    certain = std::min(certain, group.lasts());
  }
  if (anew)
    groups.take_pose(blocks, p);
}

/// Asks the prompt groups of a round one by one. Whose corner has passed an edge is not
/// certain any more, and its pair is due. Whether there is one.
template <class Rules>
bool ask_prompt(const Blocks& blocks, const Contacts& contacts, ContactGroups& groups,
                int round) {
  const ContactDecision<Rules> decision(blocks, contacts, groups);
  const bool missing = groups.watches.missing(round);
  WatchRows::Maker rows;
  bool due = false;
  for (unsigned left = groups.prompt[round]; left != 0; left &= left - 1) {
    const int p = round * pairs_of_round + std::countr_zero(left);
    ContactPair& pair = groups.pairs[p];
    for (std::uint32_t bits = pair.prompt; bits != 0; bits &= bits - 1) {
      ContactGroup& group = groups.all[pair.first + std::countr_zero(bits)];
      const int block = pair.edge_block(group);
      if (missing)
        decision.each_watched(group, block, [&](auto... edge) { rows.add(edge...); });
      if (decision.stays(group, block))
        continue;
      group.travel = 0.0F;
      groups.poses[p].certain = groups.limits[p] = 0.0F;
      due = true;
    }
  }
  if (missing && !due)
    rows.finish(groups.watches, round);
  return due;
}

/// Where a third block is not certainly away any more a group of a window is not
/// certain either, and its pair is due.
inline void ask_thirds(const Blocks& blocks, ContactGroups& groups, int window) {
  const std::vector<double>& way = groups.swing.way;
  groups.thirds.each(window, [&](ThirdBlock& third) {
    const ContactPair& pair = groups.pairs[third.pair];
    const double ways = way[pair.low] + way[pair.high] + way[third.block];
    if (ways < third.limit)
      return;
    const auto [c, surface] = third.place;
    const double travel =
        away_travel(blocks, third.block, c, EdgeView(blocks, c, surface));
    third.limit = rounded_down(ways + travel);
    if (travel > 0.0)
      return;
    groups.all[third.group].travel = 0.0F;
    groups.poses[third.pair].certain = groups.limits[third.pair] = 0.0F;
    groups.rounds[third.pair / pairs_of_round] = 0.0;
  });
}

/// Decides the groups whose blocks have moved too far since they were last decided, of
/// the rounds of pairs first .. last - 1.
template <class Rules>
void renew_decisions(const Blocks& blocks, const Contacts& contacts,
                     ContactGroups& groups, double dt, int first, int last,
                     ContactGroups::Share& share) {
  const Swing& swing = groups.swing;
  const int pairs = static_cast<int>(groups.pairs.size());
  const LaneArithmetic& arithmetic = lane_arithmetic();
  const BlockRows rows = rows_of(blocks);
  for (int round = first; round < last; ++round) {
    const bool due =
        groups.prompt[round] != 0 &&
        !groups.watches.all_stay(round, arithmetic, rows, geometry::contact_slack) &&
        ask_prompt<Rules>(blocks, contacts, groups, round);
    if (Rules::keeps_decisions && !due && swing.travel < groups.rounds[round])
      continue;
    unsigned prompt = 0;
    double left_of_round = std::numeric_limits<double>::max();
    for (int p = round * pairs_of_round;
         p < std::min(pairs, (round + 1) * pairs_of_round); ++p) {
      const ContactPair& pair = groups.pairs[p];
      const float& certain = groups.poses[p].certain;
      float& limit = groups.limits[p];
      const double way = swing.way[pair.low] + swing.way[pair.high];
      if (!Rules::keeps_decisions || !(way < limit)) {
        double moved = groups.relative_motion(blocks, p);
        if (!Rules::keeps_decisions || !(certain - moved > 0.0)) {
          const WatchedEdges before = groups.watched_by(pair);
          renew_pair<Rules>(blocks, contacts, groups, p, moved, dt, share);
          if (groups.watched_by(pair) != before)
            groups.watches.forget(round);
          moved = groups.relative_motion(blocks, p);
        }
        limit = rounded_down(way + (certain - moved));
      }
      left_of_round = std::min(left_of_round, limit - way);
      prompt |= (pair.prompt != 0 ? 1U : 0U) << (p % pairs_of_round);
    }
    groups.prompt[round] = static_cast<std::uint8_t>(prompt);
    // each of the two blocks goes as far as the travel tells
    groups.rounds[round] = swing.travel + 0.5 * left_of_round;
  }
}

/// Exactly what touches in the lanes of a set where that was left open, and which
/// springs have lost their contact.
template <class Rules>
void settle(const Blocks& blocks, ContactGroups& groups, int set,
            std::vector<LostForce>& lost) {
  ContactLanes& lanes = groups.lanes;
  const LanePairs& pairs = lanes.pairs[set];
  const auto at = [&](int corner) { return Vec2(blocks.corner.col(corner)); };
  for (int slot = pairs.first_slot; slot < pairs.first_slot + pairs.slots; ++slot) {
    const SlotPlaces& places = lanes.places[slot];
    SlotSprings& springs = lanes.springs[slot];
    for (int k = 0; k < lane_count; ++k) {
      const int seat = slot * lane_count + k;
      if (lanes.is(seat, &SlotPlaces::asked) && lanes.is(seat, &SlotPlaces::touches) &&
          Rules::overlap_sign(at(places.corner[k]), at(places.edge[k]),
                              at(places.edge_end[k])) <= 0)
        lanes.set(seat, &SlotPlaces::touches, false);
      if (lanes.is(seat, &SlotPlaces::touches))
        continue;
      if (springs.normal_elastic[k] > 0.0) {
        lost.push_back({groups.group_of(seat), groups.record[seat],
                        springs.normal_elastic[k], springs.shear_elastic[k]});
      }
      springs.normal_elastic[k] = springs.shear_elastic[k] = 0.0;
    }
  }
}

}  // namespace detail

/// evaluate_contacts (contact_forces.hpp) for any rules.
template <class Rules>
Extremes evaluate_contacts_by(const Blocks& blocks, Contacts& contacts,
                              ContactGroups& groups, const Settings& settings,
                              double dt, Workers& workers, Profile* profile = nullptr) {
  const ContactLaw law{settings.normal_stiffness, settings.shear_stiffness,
                       settings.friction, dt};
  const int rounds = static_cast<int>(groups.rounds.size());
  {
    const Profile::Timer timer(profile, Profile::decisions);
    // of a new list lanes are made once it is known who may act
    const bool made = groups.times_made > 0;
    if (made && !groups.loaded)
      groups.load(blocks, contacts, settings);
    groups.read = false;
    // window by window: no other thread writes to the sets of a window
    workers.each(groups.split.windows, [&](int part, int first, int last) {
      const detail::ExactCalls calls(profile, groups.shares[part]);
      const int first_round = first * rounds_of_window,
                last_round = std::min(rounds, last * rounds_of_window);
      for (int window = first; window < last; ++window)
        detail::ask_thirds(blocks, groups, window);
      detail::renew_decisions<Rules>(blocks, contacts, groups, dt, first_round,
                                     last_round, groups.shares[part]);
    });
    groups.join_shares();
    if (!made || !groups.seats_complete) {
      groups.store(contacts);
      groups.make_lanes(contacts);
      groups.load(blocks, contacts, settings);
    }
  }
  const Profile::Timer timer(profile, Profile::forces);
  const LaneArithmetic& arithmetic = lane_arithmetic();
  const BlockRows rows = rows_of(blocks);
  const auto include = [&](int part, const LaneExtremes& most) {
    groups.shares[part].extremes.include(most.overlap, most.spring);
  };
  const auto act = [&](int part, int set) {
    include(part, arithmetic.act(groups.lanes, rows, law, settings.rigid, false, set,
                                 set + 1));
  };
  workers.each(groups.split.sets, [&](int part, int first, int last) {
    const detail::ExactCalls calls(profile, groups.shares[part]);
    include(part, arithmetic.touch_and_act(groups.lanes, rows, law, settings.rigid,
                                           first, last));
    for (int set = first; set < last; ++set)
      if (groups.lanes.pairs[set].look) {
        detail::settle<Rules>(blocks, groups, set, groups.shares[part].lost);
        act(part, set);
      }
  });
  groups.join_shares();
  if constexpr (Rules::hands_over) {
    hand_over(blocks, contacts, groups, settings.normal_stiffness);
    for (const int set : groups.heirs)
      act(0, set);
  }
  groups.lost.clear();
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
