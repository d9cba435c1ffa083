#include "study/corner_rules/corner_rules.hpp"

#include <utility>

#include "study/corner_rules/corner_decision.hpp"

namespace blocks::study {

void CornerRules::decide(const Blocks& blocks, const dynamics::BlockParts&,
                         const dynamics::PairIndex& index, int p,
                         dynamics::PairScratch& scratch) {
  const corner_rules::CornerDecision decision(blocks, index);
  const auto [low, high] = index.pairs[p];
  scratch.found.clear();
  for (const auto& [own, other] : {std::pair(low, high), std::pair(high, low)})
    for (int c = blocks.first_corner[own]; c < blocks.first_corner[own + 1]; ++c) {
      const int edge = decision.acting_edge(c, other);
      for (const int e : {edge, decision.notch_edge(c, other, edge)})
        if (e >= 0)
          scratch.found.push_back({c, e});
    }
}

}  // namespace blocks::study
