// How deep two blocks are in each other along the normal of an edge, in whole numbers:
// what a contact may at most be deep.
#pragma once

#include <vector>

#include "audit/whole_numbers.hpp"
#include "model/blocks.hpp"

namespace blocks::audit {

class CommonDepth {
 public:
  /// The blocks as they stand: a copy of their corners in whole numbers. All
  /// coordinates finite.
  explicit CommonDepth(const Blocks& blocks);

  /// [L] Extent of the intersection of the edge's block with the other one, borders
  /// included, along the edge's normal; 0 when they have no point in common. Decided
  /// exactly, rounded at the end. Of several parts of an intersection all count. other:
  /// not the edge's own block.
  double along_normal(int edge, int other) const;

 private:
  bool holds(int block, const Point& point) const;

  const Blocks& blocks_;
  Lattice lattice_;
  std::vector<Point> corner_;
};

}  // namespace blocks::audit
