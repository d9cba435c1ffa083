// A block for tests.
#pragma once

#include "model/blocks.hpp"

namespace blocks::testing {

/// Returns a rectangular block with its lower left corner at (x, y).
inline NewBlock rectangle(double x, double y, double width, double height) {
  NewBlock block;
  block.outline = {{x, y}, {x, y + height}, {x + width, y + height}, {x + width, y}};
  block.density = 1.0;
  return block;
}

}  // namespace blocks::testing
