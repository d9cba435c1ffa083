// Contact forces: the third call of a step.
#pragma once

#include <vector>

#include "dynamics/spring_transfer.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

struct Workspace;

/// Results of one thread.
struct ForceThread {
  std::vector<ReleasedSpring> released;
  std::vector<int> broken;  ///< pairs that have lost a bond
  Extremes extremes;
};

/// Working memory of the functions below.
struct ForceMemory {
  std::vector<ForceThread> threads;
  SpringTransfer transfer;
  std::vector<int> receivers;  ///< batches that have received springs
  /// (windows + 1) the first contact of each window in the list of the model
  std::vector<int> first_contact;
};

/// Finds which potential contacts act, advances their springs and sums their forces for
/// each pair (FORD, report 2.5). The springs of contacts that ceased to act, and those
/// already released, pass to successors, if the rule has that. Decisions of pairs that
/// have lost a bond expire. Reads blocks and springs; writes the arrays. Returns the
/// largest overlap and spring of the contacts between blocks.
Extremes find_contact_forces(const Model& model, Workspace& work);

/// Computes the contacts of this step once more, for list_contacts(). Call it before
/// ContactBatches::advance_springs.
void take_readings(const Model& model, Workspace& work);

/// Writes the contacts that act to the list of the model, with their springs and the
/// states of their laws. `read`: take_readings() was called in this step. Then it also
/// writes their forces and overlaps and, for rigid blocks, the sums f_i x_j of the
/// contacts to `applied`. Otherwise these are 0. Call it after
/// ContactBatches::advance_springs.
void list_contacts(Model& model, Workspace& work, bool read);

}  // namespace blocks::dynamics
