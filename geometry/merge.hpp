// The record of MERGE: who absorbed whom, and why (report A.2.6,
// docs/departures.md#merge).
#pragma once

namespace blocks::geometry {

/// One slender block absorbed by its neighbour. Numbers count the blocks of the layer
/// before MERGE, from 1 at the left.
struct Absorption {
  int absorbed = 0;
  int into = 0;  ///< right neighbour; the left one for the last block
  double width_to_height =
      0.0;  ///< of the absorbed block (with what it had absorbed itself)
};

}  // namespace blocks::geometry
