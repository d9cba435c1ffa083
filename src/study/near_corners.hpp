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

/// Lists, for each pair of blocks, the corners that were near an edge of the other
/// block when the list was made. Corners that acted at that time are listed too.
class NearCorners {
 public:
  using Corners = std::vector<dynamics::CornerOnEdge>;

  /// Lists the corners within `reach` [L] of an edge. `index` must hold all pairs of
  /// blocks that are so near. If `keep` is set, earlier entries stay in the list.
  void find(const Model& model, const dynamics::PairIndex& index, double reach,
            bool keep);
  /// The corners listed for a pair of blocks, low < high.
  const Corners& of(int low, int high) const;
  /// The listed pairs that are not both fixed, in order.
  std::vector<dynamics::NearPair> pairs(const Blocks& blocks) const;

 private:
  void add(const Blocks& blocks, int corner, int edge);
  void add_near(const Blocks& blocks, int own, int other, double reach);

  std::map<std::pair<int, int>, Corners> listed_;  ///< by the two blocks, low < high
};

}  // namespace blocks::study
