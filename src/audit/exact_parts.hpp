// The convex parts of blocks, to which the rule is applied.
#pragma once

#include <vector>

namespace blocks::audit {

/// A convex part of a block, given by its corner numbers, clockwise.
struct ConvexPart {
  int block = 0;
  std::vector<int> corners;
};

}  // namespace blocks::audit
