// The contact rule pair by pair (dynamics/rules) in the step: which pairs have to be
// decided, and for how long a decision holds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "dynamics/contact_groups.hpp"
#include "dynamics/decided_records.hpp"
#include "dynamics/rules/pair_rule.hpp"

namespace blocks::dynamics {

/// Rules that decide pair by pair, by PairRule with these predicates.
template <class Rules>
concept Pairwise = requires {
  typename Rules::PairPredicates;
};

namespace detail {

/// Calls work(rule) with the contact rule for these predicates.
template <class Predicates, class Work>
auto with_pair_rule(const Blocks& blocks, const ContactGroups& groups,
                    PairScratch& scratch, const Predicates& predicates,
                    const Work& work) {
  const auto neighbours = [&](int b, const auto& visit) {
    groups.each_neighbour(b, visit);
  };
  PairRule<Predicates, decltype(neighbours)> rule(blocks, groups.parts, neighbours,
                                                  scratch, predicates);
  return work(rule);
}

/// The records of a group that act, at most two.
inline std::array<int, 2> acting_records(const Blocks& blocks, const Contacts& contacts,
                                         const ContactGroup& group, int block,
                                         const std::vector<CornerOnEdge>& acting) {
  std::array<int, 2> found = {-1, -1};
  std::size_t count = 0;
  const std::size_t most = group.reentrant ? 2 : 1;
  for (const CornerOnEdge& contact : acting)
    if (contact.corner == contacts.corner[group.first] &&
        blocks.corner_block[contact.edge] == block && count < most)
      for (int i = group.first; i < group.last(); ++i)
        if (contacts.edge[i] == contact.edge)
          found[count++] = i;
  return found;
}

/// Decides pair p. First the contacts that may act are looked for with room for so many
/// steps of the present motion: the pair needs no other decision before. If they are in
/// doubt, the contacts that act in this step are decided exactly; after two failures
/// room is not tried again for some decisions.
template <class Rules>
void decide_pair(const Blocks& blocks, const Contacts& contacts, ContactGroups& groups,
                 int p, double dt, ContactGroups::Share& share) {
  constexpr unsigned char shortest = 3, longest = 14, steps_between_tries = 32;
  ContactPair& pair = groups.pairs[p];
  PairPose& pose = groups.poses[p];
  PairRoom& kept = groups.pair_rooms[p];
  PairScratch& scratch =
      groups.scratch[static_cast<std::size_t>(&share - groups.shares.data())];
  double room = 0.0;
  bool by_travel = false;
  if (Rules::keeps_decisions && kept.wait == 0) {
    const double motion = motion_of_step(blocks, groups.swing, pair, dt);
    const double wanted = std::ldexp(motion, kept.life);
    with_pair_rule(blocks, groups, scratch, PredicatesWithRoom(wanted),
                   [&](auto& rule) {
                     if (rule.settle(pair.low, pair.high))
                       room = wanted;
                     by_travel = rule.predicates().asked_neighbours();
                   });
    if (room > 0.0) {
      kept.life = std::min<unsigned char>(kept.life + 2, longest);
    } else if (kept.life > shortest) {
      kept.life = static_cast<unsigned char>(std::max<int>(kept.life - 4, shortest));
    } else {
      kept.wait = steps_between_tries;
    }
  } else if (kept.wait > 0) {
    --kept.wait;
  }
  if (!(room > 0.0)) {
    const typename Rules::PairPredicates exact{};
    with_pair_rule(blocks, groups, scratch, exact,
                   [&](auto& rule) { rule.decide(pair.low, pair.high); });
  }
  kept.by_travel = by_travel && room > 0.0;
  pose.certain = rounded_down(room);
  if (room > 0.0) {
    groups.take_pose(blocks, p);
    kept.travel = groups.swing.travel;
  }
  for (int g = pair.first; g < groups.end_of(p); ++g) {
    ContactGroup& group = groups.all[g];
    if (group.of_notch)
      continue;
    const auto records =
        acting_records(blocks, contacts, group, pair.edge_block(group), scratch.found);
    for (int k = g; k <= g + static_cast<int>(group.reentrant); ++k)
      groups.all[k].travel = pose.certain;
    group.set_record(records[0]);
    seat_records(blocks, contacts, groups, g, records[1], share);
  }
}

/// How far blocks have moved since the decision of pair p, [L]: its own two against
/// each other, or any two if the decision depends on neighbours.
inline double moved_since(const Blocks& blocks, const ContactGroups& groups, int p) {
  return groups.pair_rooms[p].by_travel
             ? 2.0 * (groups.swing.travel - groups.pair_rooms[p].travel)
             : groups.relative_motion(blocks, p);
}

/// renew_decisions for rules that decide pair by pair.
template <class Rules>
void renew_pairs(const Blocks& blocks, const Contacts& contacts, ContactGroups& groups,
                 double dt, int first, int last, ContactGroups::Share& share) {
  const Swing& swing = groups.swing;
  const int pairs = static_cast<int>(groups.pairs.size());
  for (int round = first; round < last; ++round) {
    if (Rules::keeps_decisions && swing.travel < groups.rounds[round])
      continue;
    double left_of_round = std::numeric_limits<double>::max();
    for (int p = round * pairs_of_round;
         p < std::min(pairs, (round + 1) * pairs_of_round); ++p) {
      const ContactPair& pair = groups.pairs[p];
      const float& certain = groups.poses[p].certain;
      float& limit = groups.limits[p];
      const double way = swing.way[pair.low] + swing.way[pair.high];
      if (groups.pair_rooms[p].by_travel || !(way < limit)) {
        double moved = moved_since(blocks, groups, p);
        if (!(certain - moved > 0.0)) {
          decide_pair<Rules>(blocks, contacts, groups, p, dt, share);
          moved = 0.0;
        }
        limit = rounded_down(way + (certain - moved));
      }
      left_of_round = std::min(left_of_round, limit - way);
    }
    // each of the two blocks goes as far as the travel tells
    groups.rounds[round] = swing.travel + 0.5 * left_of_round;
  }
}

}  // namespace detail
}  // namespace blocks::dynamics
