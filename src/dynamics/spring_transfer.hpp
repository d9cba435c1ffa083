// Passes the springs of contacts that have ceased to act to other contacts of the same
// corner, or to nearly parallel edges of the same pair
// (docs/departures.md#hand-over-of-springs).
#pragma once

#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/support/workers.hpp"

namespace blocks::dynamics {

/// The contact that takes over a released spring, and its springs after the transfer.
struct Successor {
  int slot = -1, batch = -1;  ///< -1: no contact can take the spring
  /// [F] normal spring of the successor before the transfer
  double before = 0.0;
  double normal = 0.0, shear = 0.0;  ///< [F] its springs after the transfer
  /// [F/L] its stiffnesses after the transfer, if the released springs are added to its
  /// own; otherwise 0
  double stiffness = 0.0, shear_stiffness = 0.0;
  /// [L] its offset after the transfer, only if the released contact was held by an
  /// offset after INSITU; otherwise 0
  double offset = 0.0;

  bool adds() const { return stiffness > 0.0; }
};

/// Working memory of transfer_springs.
struct SpringTransfer {
  std::vector<ReleasedSpring> released;  ///< in any order
  std::vector<Successor> successors;     ///< (released)
};

/// Passes each released spring to the contact whose normal spring it strengthens most.
/// A candidate acts. It has the same corner and an edge within 90 degrees, or it
/// belongs to the same pair and has a nearly parallel edge
/// (geometry::successor_cosine). It takes the shear spring only if it has none. A
/// contact whose law has a stiffness of its own passes its springs only to another one.
/// Then the edges must be nearly parallel in any case, and the candidate nearest to the
/// released corner takes the springs: forces and stiffnesses are added to its own
/// (docs/laws.md#length). After INSITU, springs held by an offset are added in any
/// case, and the successor is held too (docs/rest.md#stress-in-the-ground). All
/// released springs choose a successor at the same time. They are then passed on in the
/// order of pair, corner and edge, whatever their order in the list. If the chosen
/// contact has received another spring in the meantime, the choice is repeated. Each
/// batch that has received springs is listed once in `receivers`.
void transfer_springs(const Blocks& blocks, ContactArrays& arrays,
                      const Settings& settings, Workers& workers,
                      SpringTransfer& transfer, std::vector<int>& receivers);

}  // namespace blocks::dynamics
