// Decides which contacts of each pair may act, and how long each decision holds: the
// second call of a step.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/decisions/certain_decisions.hpp"
#include "dynamics/decisions/decisions.hpp"
#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/support/work_split.hpp"
#include "dynamics/support/workers.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {

/// The contact rule of every run. `blocks study` replaces it by other classes with the
/// same members.
struct ContactRules {
  /// Decisions are kept (docs/kept-decisions.md). If this is false, every pair is
  /// decided in every step.
  static constexpr bool keeps_decisions = true;
  /// The springs of contacts that cease to act pass to successors.
  static constexpr bool transfers_springs = true;

  /// Finds which contacts of pair p act and writes them to scratch.found.
  static void decide(const Blocks& blocks, const BlockParts& parts,
                     const PairIndex& index, int p, PairScratch& scratch) {
    decide_exactly<ExactPredicates>(blocks, parts, index, p, scratch);
  }

  /// Applies the contact rule with the given predicates.
  template <class Predicates>
  static void decide_exactly(const Blocks& blocks, const BlockParts& parts,
                             const PairIndex& index, int p, PairScratch& scratch) {
    const Neighbours neighbours{index};
    PairRule<Predicates, Neighbours> rule(blocks, parts, neighbours, scratch);
    rule.decide(index.pairs[p].low, index.pairs[p].high);
  }
};

/// Working memory and results of one thread.
struct DecisionThread {
  std::vector<int> due;  ///< pairs whose decisions have expired
  CertainDecisions certain;
  PairScratch scratch;
  ContactChanges changes;
  unsigned long long exact_calls = 0;  ///< questions left to exact arithmetic
};

/// Working memory of decide_contacts.
struct DecisionMemory {
  std::vector<DecisionThread> threads;
  ContactsOfPairs grown;  ///< pairs that have outgrown their slots, in order
  ContactsOfPairs kept;   ///< all contacts while the arrays are rebuilt
};

/// Decides the due pairs of a thread. A decision is kept while it certainly holds, or
/// until its renewal, or for this step alone.
template <class Rules>
void decide_due(const Rules& rules, const Blocks& blocks, const BlockParts& parts,
                const PairIndex& index, Decisions& decisions, ContactArrays& arrays,
                DecisionThread& thread) {
  if (Rules::keeps_decisions)
    thread.certain.find(blocks, parts, index, decisions, thread.due);
  for (std::size_t k = 0; k < thread.due.size(); ++k) {
    const int p = thread.due[k];
    if (Rules::keeps_decisions && thread.certain[k].room > 0.0) {
      const CertainDecision& decision = thread.certain[k];
      decisions.keep_certain(blocks, index.pairs[p], p, decision.room, decision.growth);
      arrays.assign(blocks, index, p, decision.contacts, true, thread.changes);
    } else {
      rules.decide(blocks, parts, index, p, thread.scratch);
      const PairScratch& scratch = thread.scratch;
      const bool is_kept = Rules::keeps_decisions && scratch.may_be_kept;
      arrays.assign(blocks, index, p, is_kept ? scratch.candidates : scratch.found,
                    is_kept, thread.changes);
      if (is_kept)
        decisions.keep_exact(blocks, parts, index, p, scratch.depths,
                             scratch.asked_of_third);
      else
        decisions.expire(p);
    }
  }
}

/// Finds the pairs of the half-open range [begin, end) whose decisions have expired.
template <class Rules>
void find_due(const Blocks& blocks, const BlockParts& parts, const PairIndex& index,
              Decisions& decisions, int begin, int end, std::vector<int>& due) {
  const double most = decisions.bounds.most;
  due.clear();
  for (int p = begin; p < end; ++p)
    if (!Rules::keeps_decisions || !(most < decisions.next_check[p] ||
                                     decisions.holds(blocks, parts, index.pairs[p], p)))
      due.push_back(p);
}

/// Merges the results of the threads: the pairs that have outgrown their slots, in
/// order, and the released springs.
void join_changes(DecisionMemory& memory, std::vector<ReleasedSpring>& released);

/// Gives slots to pairs that have none and may touch soon. Call it before the arrays
/// are rebuilt.
void expect_contacts(const PairIndex& index, const Decisions& decisions,
                     ContactArrays& arrays);

/// Decides the pairs whose decisions have expired and assigns their contacts to slots.
/// Reads blocks and motion bounds; writes decisions and arrays. The springs of contacts
/// that the new decisions lack are added to `released`, in any order.
template <class Rules>
void decide_contacts(const Rules& rules, const Blocks& blocks, const Settings& settings,
                     const BlockParts& parts, const PairIndex& index,
                     Decisions& decisions, ContactArrays& arrays, WorkSplit& split,
                     Workers& workers, DecisionMemory& memory,
                     std::vector<ReleasedSpring>& released) {
  const auto pairs_until = [&](int window) {
    return std::min(index.size(), window * pairs_of_window);
  };
  // A window is decided by one thread, so no other thread writes to its batches.
  workers.each(split.windows, [&](int k, int begin, int end) {
    DecisionThread& thread = memory.threads[k];
    const unsigned long long before = geometry::exact::calls();
    find_due<Rules>(blocks, parts, index, decisions, pairs_until(begin),
                    pairs_until(end), thread.due);
    decide_due(rules, blocks, parts, index, decisions, arrays, thread);
    thread.exact_calls += geometry::exact::calls() - before;
  });
  join_changes(memory, released);
  if (memory.grown.pair.empty())
    return;
  expect_contacts(index, decisions, arrays);
  arrays.copy_contacts(memory.kept);
  arrays.make(blocks, settings, index, memory.kept, memory.grown);
  split.split_batches(arrays.first_batch);
}

}  // namespace blocks::dynamics
