// Time of generating random layers.
#pragma once

namespace blocks::bench {

/// Nanoseconds of the processor for one block.
struct GenerationCost {
  double all = 0.0;          ///< cut, rounded and certified
  double certificate = 0.0;  ///< the tiling certificate, of `all` or made once more
};

/// So many layers of so many blocks each, random spacing, ORIENT +-10; slanted: between
/// lines that are not level. Throws std::runtime_error when a certificate does not
/// hold.
GenerationCost cost_of_layers(int layers, int blocks, bool slanted);

}  // namespace blocks::bench
