// Contact forces: the third call of a step.
#pragma once

#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/spring_transfer.hpp"
#include "dynamics/support/work_split.hpp"
#include "dynamics/support/workers.hpp"

namespace blocks::dynamics {

/// Results of one thread.
struct ForceThread {
  std::vector<ReleasedSpring> released;
  std::vector<int> broken;
  Extremes extremes;
};

/// Working memory of find_contact_forces.
struct ForceMemory {
  std::vector<ForceThread> threads;
  SpringTransfer transfer;
  std::vector<int> receivers;  ///< batches that have received springs
  std::vector<int> shares;     ///< splits the receivers among the threads
  /// (windows + 1) of read_contacts: the first contact of each window in the list
  std::vector<int> first_contact;
  /// Pairs that have lost a bond in this step. Their contacts must be decided again.
  std::vector<int> broken;
};

/// Finds which potential contacts act, advances their springs and sums their forces for
/// each pair (FORD, report 2.5). If `transfers_springs`, the springs of contacts that
/// ceased to act and those already in memory.transfer pass to successors. Otherwise
/// they are lost. Reads blocks and springs; writes the arrays. Returns the largest
/// overlap and spring of the contacts between blocks.
Extremes find_contact_forces(const Blocks& blocks, const Settings& settings, double dt,
                             ContactArrays& arrays, bool transfers_springs,
                             const WorkSplit& split, Workers& workers,
                             ForceMemory& memory);

/// Computes the contacts of this step once more for output. Writes springs at the end
/// of the step, forces and overlaps to the list of the model, and the states of their
/// laws to `states`. For rigid blocks it also overwrites `applied` with the sums
/// f_i x_j of the contacts. Call it after find_contact_forces and before
/// ContactBatches::advance_springs.
void read_contacts(Blocks& blocks, std::vector<Contact>& list,
                   std::vector<JointState>& states, const Settings& settings, double dt,
                   ContactArrays& arrays, const WorkSplit& split, Workers& workers,
                   ForceMemory& memory);

}  // namespace blocks::dynamics
