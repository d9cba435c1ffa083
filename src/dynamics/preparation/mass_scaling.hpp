// MSCALE: the inertial masses of free blocks during SOLVE
// (docs/rest.md#mass-scaling).
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Returns whether SOLVE scales masses: MSCALE is on, and there is a free block. The
/// dashpots of quiet sides belong to the true masses, so a model with such sides is not
/// scaled.
bool may_scale_masses(const Model& model);

/// Sets Blocks::scale so that all free blocks have the same critical time step, and the
/// time step to that. The sum of their masses stays the same. The critical step of a
/// block is that of steps_of_blocks() with contact_shares(). Velocities change with the
/// root of the masses, so the kinetic energy of each block stays.
void begin_mass_scaling(Model& model);

/// Ends it: blocks have their true masses, kinetic energies stay, and the time step is
/// chosen again. Without effect if masses are not scaled.
void end_mass_scaling(Model& model);

/// Makes the present moment that from which the times of steps are counted.
void count_time_from_here(Model& model);

/// The smallest and the largest entry of Blocks::scale of free blocks; 1 if masses are
/// not scaled.
struct MassFactors {
  double min = 1.0, largest = 1.0;
};
MassFactors mass_factors(const Blocks& blocks);

}  // namespace blocks::dynamics
