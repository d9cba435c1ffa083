// Computes in exact integers how deep two blocks overlap along the normal of an edge. A
// contact on that edge must not be deeper.
#pragma once

#include <vector>

#include "audit/whole_numbers.hpp"
#include "model/blocks.hpp"

namespace blocks::audit {

class CommonDepth {
 public:
  /// Copies the corners of the blocks as integers. All coordinates must be finite.
  explicit CommonDepth(const Blocks& blocks);

  /// Returns the extent of the intersection of the edge's block and the block `other`
  /// along the normal of the edge, borders included, [L]. If the intersection has
  /// several separate regions, the extent spans all of them. Returns 0 if the blocks
  /// have no point in common. It is decided exactly and rounded at the end. `other`
  /// must not be the edge's own block.
  double along_normal(int edge, int other) const;

 private:
  bool holds(int block, const Point& point) const;

  const Blocks& blocks_;
  Lattice lattice_;
  std::vector<Point> corner_;
};

}  // namespace blocks::audit
