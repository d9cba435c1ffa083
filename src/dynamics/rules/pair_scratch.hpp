// The contacts that the contact rule finds, and its working memory.
#pragma once

#include <algorithm>
#include <compare>
#include <memory>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/pair_shape.hpp"
#include "dynamics/rules/third_parts.hpp"
#include "geometry/polygon.hpp"
#include "model/kept_decisions.hpp"

namespace blocks::dynamics {

/// A corner that acts on an edge of another block. The edge is named by its first
/// corner.
struct CornerOnEdge {
  int corner = -1, edge = -1;
  auto operator<=>(const CornerOnEdge&) const = default;
};

/// Working memory of the rule for one thread. It grows as needed and is reused.
struct PairScratch {
  PairMemory shape;
  geometry::Polygon outline[2];  ///< of the two parts
  ThirdParts thirds[2];          ///< third parts of each of the two
  std::vector<Axis> axes;
  std::vector<CornerOnEdge> found;
  /// The contacts that may act as long as the decision is kept: each of them acts if
  /// its corner is inside its edge and between the ends.
  std::vector<CornerOnEdge> candidates;
  /// Whether the decision may be kept. If not, it is for this step alone.
  bool may_be_kept = false;
  std::vector<KeptDepth> depths;  ///< It may be kept while these are in their limits.
  /// Whether the rule was also applied to a third part with one of the two. The
  /// decision may then depend on blocks that are near one of the two only.
  bool asked_of_third = false;
  std::unique_ptr<PairScratch> of_third;  ///< for a third part with one of the two

  /// Adds a contact unless it is there already.
  static void add(std::vector<CornerOnEdge>& list, const CornerOnEdge& contact) {
    if (std::find(list.begin(), list.end(), contact) == list.end())
      list.push_back(contact);
  }
};

/// Calls visit(p, q) for each part p of the block with the lower number and each part q
/// of the other block. So of equally deep axes, one of the lower block comes first.
template <class Visit>
void each_pair_of_parts(const BlockParts& parts, int a, int b, const Visit& visit) {
  const auto [low, high] = std::minmax(a, b);
  for (int p = parts.first_part(low); p < parts.end_part(low); ++p)
    for (int q = parts.first_part(high); q < parts.end_part(high); ++q)
      visit(p, q);
}

}  // namespace blocks::dynamics
