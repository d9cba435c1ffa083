// The contacts of all pairs in one step: decide, act where they touch, hand springs
// over. A template over the rules of the decision.
#pragma once

#include "dynamics/contact_law.hpp"
#include "dynamics/pair_contacts.hpp"
#include "dynamics/pair_decisions.hpp"
#include "dynamics/profile.hpp"
#include "dynamics/spring_transfer.hpp"
#include "dynamics/workers.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {

/// Decides the pairs whose decisions no longer hold. Reads corners, velocities and
/// Swing; writes the seats.
template <class Rules>
void decide_contacts(const Rules& rules, const Blocks& blocks, PairContacts& all,
                     const Settings& settings, double dt, Workers& workers) {
  constexpr int rounds_of_one = pairs_of_one_window / pairs_of_one_round;
  const int rounds = static_cast<int>(all.rounds.size());
  // window by window: no other thread writes to the sets of a window
  workers.each(all.split.windows, [&](int part, int first, int last) {
    PairContacts::Share& share = all.shares[part];
    const unsigned long long before = geometry::exact::calls();
    renew_decisions(rules, blocks, all, dt, first * rounds_of_one,
                    std::min(rounds, last * rounds_of_one), share);
    share.exact_calls += geometry::exact::calls() - before;
  });
  if (all.join_shares()) {
    all.take_out(all.held);
    all.make_lanes(blocks, settings, all.held, all.unseated);
  }
}

/// Lets all contacts act: forces of the pairs, springs at the end of the step. Without
/// `transfers_springs` the springs of contacts that cease to act are lost.
Extremes evaluate_pairs(const Blocks& blocks, PairContacts& all,
                        const Settings& settings, double dt, Workers& workers,
                        bool transfers_springs = true);

/// Lets the contacts of this step act once more, and stores them with their readings in
/// the list of the model; of rigid blocks the applied stress. Before springs advance.
void read_pairs(Blocks& blocks, Contacts& contacts, PairContacts& all,
                const Settings& settings, double dt);

}  // namespace blocks::dynamics
