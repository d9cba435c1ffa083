// The list of potential contacts as in 1982 (report 3.2), for the variants `report` and
// `keep`.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "dynamics/rules/pair_rule.hpp"
#include "dynamics/search/pair_index.hpp"
#include "model/model.hpp"

namespace blocks::study {

/// For each pair of blocks the corners that were near an edge of the other block when
/// the list was made, and those that acted then.
class NearCorners {
 public:
  using Corners = std::vector<dynamics::CornerOnEdge>;

  /// Makes the list: corners within `reach` of an edge, [L]. The pairs have to hold all
  /// blocks that are so near. keep: what was in the list before stays in it.
  void find(const Model& model, const dynamics::PairIndex& index, double reach,
            bool keep);
  /// What is listed for a pair of blocks, low < high.
  const Corners& of(int low, int high) const;
  /// The pairs of the list that are not both fixed, ordered.
  std::vector<dynamics::NearPair> pairs(const Blocks& blocks) const;

 private:
  void add(const Blocks& blocks, int corner, int edge);
  void add_near(const Blocks& blocks, int own, int other, double reach);

  std::map<std::pair<int, int>, Corners> listed_;  ///< by the two blocks, low < high
};

}  // namespace blocks::study
