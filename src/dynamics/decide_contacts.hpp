// Decides which contacts of each pair may act, and how long each decision holds: the
// second call of a step.
#pragma once

#include <vector>

#include "dynamics/contacts/pair_contacts.hpp"
#include "dynamics/decisions/certain_decisions.hpp"
#include "dynamics/rules/pair_rule.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

struct Workspace;

/// Working memory and results of one thread.
struct DecisionThread {
  std::vector<int> due;  ///< pairs whose decisions have expired
  CertainDecisions certain;
  PairScratch scratch;
  ContactChanges changes;
  unsigned long long exact_calls = 0;  ///< questions left to exact arithmetic
};

/// Decides the pairs whose decisions have expired and assigns their contacts to slots.
/// Reads blocks and motion bounds; writes decisions and arrays. The springs of contacts
/// that the new decisions lack are released (SpringTransfer::released), in any order.
void decide_contacts(const Model& model, Workspace& work);

}  // namespace blocks::dynamics
