// The rules of runs before the contact rule, for the step by pairs.
#pragma once

#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/search/pair_index.hpp"

namespace blocks::study {

/// Members as in dynamics::ContactRules. Each corner is decided by itself.
struct CornerRules {
  static constexpr bool keeps_decisions = false, transfers_springs = true;
  static void decide(const Blocks& blocks, const dynamics::BlockParts& parts,
                     const dynamics::PairIndex& index, int p,
                     dynamics::PairScratch& scratch);
};

}  // namespace blocks::study
