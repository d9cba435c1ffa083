// Springs of contacts that have ceased to act pass to other contacts of the same corner
// or of the same faces (docs/departures.md#hand-over-of-springs).
#pragma once

#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/support/work_split.hpp"
#include "dynamics/support/workers.hpp"

namespace blocks::dynamics {

/// The contact that takes over a released spring, and the spring that it then has.
struct Successor {
  int slot = -1, batch = -1;         ///< -1: no contact can take anything
  double before = 0.0;               ///< [F] its normal spring without the released one
  double normal = 0.0, shear = 0.0;  ///< [F] its springs with the released one
};

/// Working memory of transfer_springs.
struct SpringTransfer {
  std::vector<ReleasedSpring> released;  ///< in any order
  std::vector<Successor> successors;     ///< (released)
  std::vector<int> shares;               ///< of the threads in them
};

/// Passes each released spring to the contact whose spring it strengthens most: one of
/// the same corner, or one of the same pair whose edge is nearly parallel. All choose
/// at the same time; then springs are passed on in the order of pair, corner and edge,
/// whatever order they come in. If a spring's choice has received another one, it
/// chooses again. Lists in `receivers` each batch that has received springs, once.
/// normal_stiffness: [F/L].
void transfer_springs(const Blocks& blocks, ContactArrays& arrays,
                      double normal_stiffness, const WorkSplit& split, Workers& workers,
                      SpringTransfer& transfer, std::vector<int>& receivers);

}  // namespace blocks::dynamics
