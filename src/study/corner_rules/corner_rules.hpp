// The rules of runs before the contact rule, in the form used by a step over pairs.
#pragma once

#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/search/pair_index.hpp"

namespace blocks::study {

/// Has the members of dynamics::ContactRules. Each corner is decided independently.
struct CornerRules {
  static constexpr bool keeps_decisions = false, transfers_springs = true;
  static void decide(const Blocks& blocks, const dynamics::BlockParts& parts,
                     const dynamics::PairIndex& index, int p,
                     dynamics::PairScratch& scratch);
};

}  // namespace blocks::study
