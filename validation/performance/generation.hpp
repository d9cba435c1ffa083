// Times the generation of random layers.
#pragma once

namespace blocks::bench {

/// Processor time per block, in nanoseconds.
struct GenerationCost {
  double all = 0.0;          ///< cutting, rounding and certifying
  double certificate = 0.0;  ///< the tiling certificate alone
};

/// Times `layers` layers of `blocks` blocks each, with random spacing and ORIENT +-10.
/// The bounding lines of slanted layers are not level. Throws std::runtime_error if a
/// certificate does not hold.
GenerationCost cost_of_layers(int layers, int blocks, bool slanted);

}  // namespace blocks::bench
