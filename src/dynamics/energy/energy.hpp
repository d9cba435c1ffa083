// Keeps the energy account of a model (docs/laws.md#energy). count_forces and
// count_motion follow stages of a step, count_fixed and count_cracks events after it.
// They read the state of the step and change nothing but the account. Its sums are
// taken in the order of contacts and blocks, so they depend neither on threads nor on
// restarts.
#pragma once

#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/energy/block_energy.hpp"
#include "dynamics/energy/energy_tally.hpp"
#include "dynamics/support/workers.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Working memory of the account.
struct EnergyMemory {
  std::vector<BlockMotion> before;  ///< (n) motion before the step
  std::vector<BlockMasses> masses;  ///< (n) before the step
  std::vector<double> damped;  ///< [F L] (n) taken by LOCDAMP and MDAMP in the step
  bool stopped = false;        ///< the step has stopped the blocks (KINDAMP)
  std::vector<ContactTally> contact_tallies;
  std::vector<BlockTally> block_tallies;
};

/// Begins the account if HISTORY names one of its entries. Once begun, an account is
/// kept until the end of the run.
void begin_energy(Model& model);

/// Adds what contacts, planes and loads do in this step. Call it when the contact
/// forces are known, before planes and loads are added to the blocks. list_is_current:
/// Model::contacts has the springs from before the step, so cards may have changed the
/// model.
void count_forces(Model& model, const ContactArrays& arrays, bool list_is_current,
                  Workers& workers, EnergyMemory& memory);

/// Adds what the motion of the step has done. Call it before blocks that have left the
/// domain are fixed. gravity: [L/T^2] at the start of the step; stopped: the step has
/// stopped the blocks before it moved them (KINDAMP).
void count_motion(Model& model, const Vec2& gravity, bool stopped, Workers& workers,
                  EnergyMemory& memory);

/// Takes what cracks have released. Call it after blocks have split, with the list of
/// contacts up to date.
void count_cracks(Model& model, Workers& workers, EnergyMemory& memory);

/// Takes the energy of blocks that were fixed at the end of the step.
void count_fixed(Model& model, const ContactArrays& arrays, Workers& workers,
                 EnergyMemory& memory);

}  // namespace blocks::dynamics
