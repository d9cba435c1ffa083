// Record of the blocks that MERGE absorbed, and why (report A.2.6,
// docs/departures.md#merge).
#pragma once

namespace blocks::geometry {

/// One slender block absorbed by its neighbour. Numbers count the blocks of the layer
/// before MERGE, from 1 at the left.
struct Absorption {
  int absorbed = 0;
  int into = 0;  ///< the right neighbour, or the left one for the last block
  /// Width/height of the absorbed block, including blocks that it had absorbed itself.
  double width_to_height = 0.0;
};

}  // namespace blocks::geometry
