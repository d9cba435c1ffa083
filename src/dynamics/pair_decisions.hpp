// Which contacts of a pair act (dynamics/rules), and for how long that holds.
#pragma once

#include <algorithm>
#include <limits>

#include "dynamics/certain_decisions.hpp"
#include "dynamics/pair_contacts.hpp"
#include "dynamics/rules/pair_rule.hpp"

namespace blocks::dynamics {

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
  /// Decisions are kept while they are certain to hold (certain_decisions.hpp). If
  /// false, every pair is decided in every step.
  static constexpr bool keeps_decisions = true;
  /// The springs of contacts that cease to act pass to others.
  static constexpr bool transfers_springs = true;

  /// Finds which contacts of pair p act: scratch.found.
  static void decide(const Blocks& blocks, const PairContacts& all, int p,
                     PairScratch& scratch) {
    decide_exactly<ExactPredicates>(blocks, all, p, scratch);
  }
};

/// Decides the due pairs of a share: until blocks have moved by some room, or for this
/// step alone.
template <class Rules>
void decide_due(const Rules& rules, const Blocks& blocks, PairContacts& all, double dt,
                PairContacts::Share& share) {
  if (Rules::keeps_decisions)
    share.decisions.find(blocks, all, share.due, dt);
  for (std::size_t k = 0; k < share.due.size(); ++k) {
    const int p = share.due[k];
    DecisionLimits& limits = all.limits[p];
    limits = {};
    const bool certain = Rules::keeps_decisions && share.decisions[k].room > 0.0;
    if (certain) {
      const CertainDecision& decision = share.decisions[k];
      limits.way = all.ways_of_two(p) + decision.room;
      // a neighbour and one of the two move against each other by twice the travel
      limits.travel = all.swing.travel + 0.5 * decision.room_of_neighbours;
      limits.ways = decision.room_of_neighbours;
      if (limits.ways < std::numeric_limits<double>::infinity())
        limits.ways += all.ways_of_neighbours(p);
      all.seat(blocks, p, decision.contacts, true, share);
    } else {
      rules.decide(blocks, all, p, share.scratch);
      all.seat(blocks, p, share.scratch.found, false, share);
    }
    double& look = all.rounds[p / pairs_of_one_round];
    look = std::min(look, all.swing.travel + std::max(0.0, all.left_of(p)));
  }
}

/// Decides the pairs whose decisions no longer hold, of rounds first .. last - 1.
template <class Rules>
void renew_decisions(const Rules& rules, const Blocks& blocks, PairContacts& all,
                     double dt, int first, int last, PairContacts::Share& share) {
  const int pairs = static_cast<int>(all.pairs.size());
  share.due.clear();
  for (int round = first; round < last; ++round) {
    if (Rules::keeps_decisions && all.swing.travel < all.rounds[round])
      continue;
    double least = std::numeric_limits<double>::max();
    const int begin = round * pairs_of_one_round;
    for (int p = begin; p < std::min(pairs, begin + pairs_of_one_round); ++p) {
      const double left = Rules::keeps_decisions ? all.left_of(p) : 0.0;
      if (left > 0.0)
        least = std::min(least, left);
      else
        share.due.push_back(p);
    }
    all.rounds[round] = all.swing.travel + least;
  }
  decide_due(rules, blocks, all, dt, share);
}

}  // namespace blocks::dynamics
