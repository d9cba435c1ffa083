// Locates a point in a block of any shape, for the variant `corners`.
#pragma once

#include "model/blocks.hpp"
#include "study/corner_rules/reentrant_block.hpp"

namespace blocks::study::corner_rules {

class PlaceInBlock {
 public:
  explicit PlaceInBlock(const Blocks& blocks) : blocks_(blocks) {}

  /// Returns the only edge of a convex block that the point is outside of, up to the
  /// slack, or `none` or `several`.
  static constexpr int none = -1, several = -2;
  int outside_of(const Vec2& point, int block) const {
    int out = none;
    for (int e = blocks_.first_corner[block]; e < blocks_.first_corner[block + 1]; ++e)
      if (!geometry::near_or_inside(point, blocks_.corner.col(e),
                                    blocks_.corner.col(blocks_.next[e]))) {
        if (out != none)
          return several;
        out = e;
      }
    return out;
  }

  /// Whether the block holds the point, up to the slack.
  bool holds(const Vec2& point, int block) const {
    return blocks_.convex[block] ? outside_of(point, block) == none
                                 : ReentrantBlock(blocks_, block).holds(point);
  }

 private:
  const Blocks& blocks_;
};

}  // namespace blocks::study::corner_rules
