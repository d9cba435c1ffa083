// The list of potential contacts as in 1982 (report 3.2), for the variant `report`.
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
  /// blocks that are so near.
  void find(const Model& model, const dynamics::PairIndex& index, double reach);
  /// The corners listed for a pair of blocks, low < high.
  const Corners& of(int low, int high) const;

 private:
  void add(const Blocks& blocks, int corner, int edge);
  void add_near(const Blocks& blocks, int own, int other, double reach);

  std::map<std::pair<int, int>, Corners> listed_;  ///< by the two blocks, low < high
};

}  // namespace blocks::study
