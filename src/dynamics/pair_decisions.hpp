// Which contacts of a pair act (dynamics/rules), and for how long that holds.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/pair_contacts.hpp"
#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/rules/pair_settling.hpp"

namespace blocks::dynamics {

/// For the contact rule: the blocks that a block is paired with.
struct Neighbours {
  const PairContacts& all;
  template <class Visit> void operator()(int block, const Visit& visit) const {
    all.each_neighbour(block, visit);
  }
};

/// Finds which contacts of pair p act by the contact rule with these predicates.
template <class Predicates>
void decide_exactly(const Blocks& blocks, const PairContacts& all, int p,
                    PairScratch& scratch) {
  const Neighbours neighbours{all};
  PairRule<Predicates, Neighbours> rule(blocks, all.parts, neighbours, scratch);
  rule.decide(all.pairs[p].low, all.pairs[p].high);
}

/// The contact rule of every run. `blocks study` replaces it by classes with the same
/// members.
struct ContactRules {
  /// Decisions are kept while they are sure to hold (settle_pair). If false, every pair
  /// is decided in every step.
  static constexpr bool keeps_decisions = true;
  /// The springs of contacts that cease to act pass to others.
  static constexpr bool transfers_springs = true;

  /// Finds which contacts of pair p act: scratch.found.
  static void decide(const Blocks& blocks, const PairContacts& all, int p,
                     PairScratch& scratch) {
    decide_exactly<ExactPredicates>(blocks, all, p, scratch);
  }
};

/// Looks for the contacts of pair p that may act, with room for motion: four times as
/// many steps of the present motion as last time, then fewer. False: all is in doubt,
/// and is not tried again for some decisions.
inline bool settle_pair(const Blocks& blocks, PairContacts& all, int p, double dt,
                        PairScratch& scratch) {
  constexpr int shortest = 3, longest = 14;  // log2 of steps
  constexpr int decisions_between_tries = 32;
  constexpr double part_of_size = 0x1p-7;
  const NearPair& pair = all.pairs[p];
  KeptDecision& kept = all.kept[p];
  if (kept.wait > 0) {
    --kept.wait;
    return false;
  }
  const double motion = motion_of_step(blocks, all.swing, pair.low, pair.high, dt);
  const double of_neighbours = part_of_size * std::min(all.swing.longest[pair.low],
                                                       all.swing.longest[pair.high]);
  const Neighbours neighbours{all};
  const double rounded = all.rounding(blocks, p);
  for (int life = kept.life; life >= shortest; life -= 3) {
    const double room = std::ldexp(motion, life);
    PairSettling settling(blocks, all.parts, neighbours, scratch,
                          PredicatesWithRoom(room + rounded, of_neighbours + rounded));
    if (settling.settle(pair.low, pair.high)) {
      kept.room_of_ends = settling.ends_are_open() ? 0.0 : room;
      kept.room_of_neighbours = std::max(0.0, settling.room_of_neighbours() - rounded);
      kept.room = room;
      kept.life = static_cast<unsigned char>(std::min(life + 2, longest));
      return true;
    }
  }
  kept.life = shortest;
  kept.wait = decisions_between_tries;
  return false;
}

/// Decides pair p: for some time, or for this step alone.
template <class Rules>
void decide_pair(const Rules& rules, const Blocks& blocks, PairContacts& all, int p,
                 double dt, PairContacts::Share& share) {
  KeptDecision& kept = all.kept[p];
  const bool settled =
      Rules::keeps_decisions && settle_pair(blocks, all, p, dt, share.scratch);
  if (settled) {
    all.place(blocks, p);
  } else {
    kept.room = kept.room_of_neighbours = 0.0;
    rules.decide(blocks, all, p, share.scratch);
  }
  all.seat(blocks, p, share.scratch.found, settled, share);
}

/// Decides pair p if its decision no longer holds. How far the travel (Swing) may grow
/// before that has to be asked again, [L].
template <class Rules>
double renew_decision(const Rules& rules, const Blocks& blocks, PairContacts& all,
                      int p, double dt, PairContacts::Share& share) {
  const Swing& swing = all.swing;
  const NearPair& pair = all.pairs[p];
  const KeptDecision& kept = all.kept[p];
  PairLimits& limits = all.limits[p];
  const double way = swing.way[pair.low] + swing.way[pair.high];
  if (!(way < limits.way && swing.travel < limits.travel)) {
    double left = all.room_left(blocks, p);
    double left_of_neighbours = all.room_of_neighbours_left(p);
    if (!(left > 0.0 && left_of_neighbours > 0.0)) {
      decide_pair(rules, blocks, all, p, dt, share);
      left = kept.room, left_of_neighbours = all.room_of_neighbours_left(p);
    }
    if (left > 0.0 && !(kept.room - left < kept.room_of_ends)) {
      all.ask_ends(blocks, p);
      left = kept.room;
    }
    const double of_ends = kept.room_of_ends - (kept.room - left);
    limits.way = way + std::min(left, of_ends);
    limits.travel = swing.travel + left_of_neighbours / all.ways(p);
  }
  // each of the two blocks goes as far as the travel tells
  return std::min(0.5 * (limits.way - way), limits.travel - swing.travel);
}

/// Decides the pairs whose decisions no longer hold, of rounds first .. last - 1.
template <class Rules>
void renew_decisions(const Rules& rules, const Blocks& blocks, PairContacts& all,
                     double dt, int first, int last, PairContacts::Share& share) {
  const int pairs = static_cast<int>(all.pairs.size());
  for (int round = first; round < last; ++round) {
    if (Rules::keeps_decisions && all.swing.travel < all.rounds[round])
      continue;
    double left = std::numeric_limits<double>::max();
    const int begin = round * pairs_of_one_round;
    for (int p = begin; p < std::min(pairs, begin + pairs_of_one_round); ++p)
      left = std::min(left, renew_decision(rules, blocks, all, p, dt, share));
    all.rounds[round] = all.swing.travel + left;
  }
}

}  // namespace blocks::dynamics
