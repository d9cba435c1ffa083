// The contact rule as the step calls it. Runs have the rule of docs/contact-rule.md;
// `blocks study` puts others in its place.
#pragma once

#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/search/pair_index.hpp"

namespace blocks::dynamics {

/// Decides the pairs that the kernel leaves open, one virtual call for each.
class ContactRule {
 public:
  /// What a step does in addition to deciding pairs.
  struct Options {
    /// Decisions are kept (docs/kept-decisions.md), and pairs that are certain in
    /// doubles are decided by the kernel. Otherwise every pair is decided by the rule
    /// in every step.
    bool keeps_decisions = true;
    /// The springs of contacts that cease to act pass to successors.
    bool transfers_springs = true;
  };

  explicit ContactRule(const Options& chosen) : options(chosen) {}
  virtual ~ContactRule() = default;

  /// Finds which contacts of pair p act and writes them to scratch.found. If decisions
  /// are kept, it also writes scratch.candidates, may_be_kept, depths and
  /// asked_of_third.
  virtual void decide(const Blocks& blocks, const BlockParts& parts,
                      const PairIndex& index, int p, PairScratch& scratch) const = 0;

  const Options options;
};

/// The rule of docs/contact-rule.md, or some parts of it.
class PairwiseRule : public ContactRule {
 public:
  explicit PairwiseRule(const Options& chosen = {}, const RuleParts& with = {})
      : ContactRule(chosen), with_(with) {}

  void decide(const Blocks& blocks, const BlockParts& parts, const PairIndex& index,
              int p, PairScratch& scratch) const override {
    decide_pair(blocks, parts, index.neighbours, index.pairs[p].low,
                index.pairs[p].high, with_, scratch);
  }

 private:
  RuleParts with_;
};

/// Returns the rule of every run.
inline const ContactRule& exact_rule() {
  static const PairwiseRule rule;
  return rule;
}

}  // namespace blocks::dynamics
