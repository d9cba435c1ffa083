// Springs of contacts that have ceased to act pass to other contacts of the same corner
// or of the same faces (docs/departures.md#hand-over-of-springs).
#pragma once

#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"

namespace blocks::dynamics {

/// Gives each released spring to the contact whose spring it strengthens most: one of
/// the same corner, or one of the same pair whose edge is nearly parallel. Springs are
/// taken in the order of pair, corner and edge, whatever order they come in. Returns in
/// `successors` the batches whose contacts have received some of them, in ascending
/// order. normal_stiffness: [F/L].
void transfer_springs(const Blocks& blocks, const PairIndex& index,
                      ContactArrays& arrays, double normal_stiffness,
                      std::vector<ReleasedSpring>& released,
                      std::vector<int>& successors);

}  // namespace blocks::dynamics
