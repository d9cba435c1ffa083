// What contacts do in one step: the third call.
#pragma once

#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/spring_transfer.hpp"
#include "dynamics/support/work_split.hpp"
#include "dynamics/support/workers.hpp"

namespace blocks::dynamics {

/// What one thread finds.
struct ForceThread {
  std::vector<ReleasedSpring> released;
  Extremes extremes;
};

/// Working memory of find_contact_forces.
struct ForceMemory {
  std::vector<ForceThread> threads;
  SpringTransfer transfer;
  std::vector<int> receivers;  ///< batches that have received springs
  std::vector<int> shares;     ///< of the threads in them
};

/// Finds which tested contacts act, advances their springs and sums their forces pair
/// by pair (FORD, report 2.5). Springs of contacts that ceased to act, and those
/// already in memory.transfer, pass to successors if `transfers_springs`; otherwise
/// they are lost. Reads blocks and springs; writes arrays.
Extremes find_contact_forces(const Blocks& blocks, const Settings& settings, double dt,
                             ContactArrays& arrays, bool transfers_springs,
                             const WorkSplit& split, Workers& workers,
                             ForceMemory& memory);

/// Computes the contacts of this step once more, for readers: writes the list of the
/// model with springs at the end of the step, forces and overlaps, and of rigid blocks
/// the sums f_i x_j of the contacts to `applied`. Call it after find_contact_forces and
/// before springs advance.
void read_contacts(Blocks& blocks, std::vector<Contact>& list, const Settings& settings,
                   double dt, const PairIndex& index, ContactArrays& arrays);

}  // namespace blocks::dynamics
