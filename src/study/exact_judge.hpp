// Whether the contacts that acted in a step are those of the default rules.
#pragma once

#include <tuple>
#include <vector>

#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/search/pair_index.hpp"
#include "study/measure.hpp"

namespace blocks::study {

/// The default rules at the positions of another run: every pair is decided in every
/// step, in a list of pairs of its own that reaches twice as far.
class ExactJudge {
 public:
  /// Decides where the blocks are.
  void decide(const Model& model);
  /// Compares with the contacts that acted in the step from there.
  void compare(const Blocks& blocks, const std::vector<Contact>& contacts,
               Outcome& outcome) const;

 private:
  using Key = std::tuple<int, int, int, int>;  ///< two blocks, corner, edge

  dynamics::PairIndex index_;
  dynamics::BlockParts parts_;
  dynamics::NearSearch near_;
  dynamics::PairScratch scratch_;
  long seen_ = -1;  ///< NUPDAT when the pairs were found
  std::vector<Key> acting_;
};

}  // namespace blocks::study
