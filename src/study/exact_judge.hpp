// Compares the contacts that acted in a step with those of the default rules.
#pragma once

#include <tuple>
#include <vector>

#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/search/pair_index.hpp"
#include "study/measure.hpp"

namespace blocks::study {

/// Applies the default rules at the positions of another run. It decides every pair in
/// every step. Its own list of pairs reaches twice as far.
class ExactJudge {
 public:
  /// Decides all pairs at the present positions.
  void decide(const Model& model);
  /// Compares the decisions with the contacts that acted in the step from these
  /// positions.
  void compare(const Blocks& blocks, const std::vector<Contact>& contacts,
               Outcome& outcome) const;

 private:
  using Key = std::tuple<int, int, int, int>;  ///< two blocks, corner, edge

  dynamics::PairIndex index_;
  dynamics::BlockParts parts_;
  dynamics::NearSearch near_;
  dynamics::PairScratch scratch_;
  long seen_ = -1;  ///< search (NUPDAT) of the present pairs
  std::vector<Key> acting_;
};

}  // namespace blocks::study
