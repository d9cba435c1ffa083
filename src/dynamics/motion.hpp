// Equations of motion, strain rates, internal stress and corners (MOTION and STRESS,
// report 2.1, 2.3, 2.4): the fifth call of a step.
#pragma once

#include <vector>

#include "dynamics/contacts/contact_arrays.hpp"
#include "dynamics/decisions/motion_bounds.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "dynamics/support/workers.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// The half-open range [begin, end) of block numbers.
struct BlockRange {
  int begin = 0, end = 0;
};
inline BlockRange all_of(const Blocks& blocks) { return {0, blocks.size()}; }

/// How far blocks moved in a step.
struct Displacement {
  /// [L] UDMAX, an upper bound of the motion of every corner: the distance that the
  /// centroid moved plus the change of the longest arm.
  double largest = 0.0;
  int block = -1;  ///< the first block that reached `largest`
  /// [L] what the step adds to MotionBounds::longest_path in this step.
  double bound = 0.0;
  bool finite = true;        ///< whether all corners are finite numbers
  bool left_domain = false;  ///< whether some corner lies outside the domain

  /// Merges the displacement of other blocks into this one.
  void include(const Displacement& others);
};

/// What a step does to all blocks alike.
struct StepMotion {
  double dt = 0.0;  ///< [T]
  /// [T] the time in which forces change velocities and strain rates: dt, or half of it
  /// if the blocks start from rest at their present positions
  double kick = 0.0;
  Vec2 gravity = {0, 0};  ///< [L/T^2] acceleration at the start of the step
  /// Whether blocks.force, moment and applied hold the loads.
  bool loaded = false;
  /// [F L] (n) receives the energy that LOCDAMP and MDAMP take from each block; it is 0
  /// before the step. Null without an energy account.
  double* damped = nullptr;
};

/// Sums the forces of contacts for each block, in the order of the pairs, and moves all
/// blocks by one step. If `loaded`, the contacts are added to the loads; otherwise
/// blocks.force, moment and applied are overwritten. Reads forces of pairs
/// and settings; writes blocks and bounds. shares: WorkSplit::blocks; threads: working
/// memory, one for each thread.
Displacement move_blocks(Blocks& blocks, const Settings& settings,
                         const StepMotion& step, const ContactArrays& contacts,
                         MotionBounds& bounds, const std::vector<int>& shares,
                         Workers& workers, std::vector<Displacement>& threads);

// The stages of move_blocks, each for a range of blocks.

/// (9): computes force and moment of the contacts. In deformable runs it also computes
/// the applied stress, which is the sum of f_i x_j divided by the area.
void sum_contacts(Blocks& blocks, const ContactArrays& contacts, BlockRange range,
                  bool loaded, bool rigid);

/// Damps the unbalanced forces of free blocks by the factor Settings::local_damping
/// (docs/rest.md#local-damping). Reads force, moment, applied stress and gravity;
/// changes velocities, spins and strain rates. Call it before update_velocities.
void damp_unbalanced(Blocks& blocks, BlockRange range, const Settings& settings,
                     const StepMotion& step, const Kernels& chosen = kernels());

/// (1), (2): updates velocities and spins of free blocks from force, moment and
/// gravity. kick: StepMotion::kick.
void update_velocities(Blocks& blocks, BlockRange range, const Vec2& gravity,
                       double kick, const Kernels& chosen = kernels());

/// (10): updates the strain rates of free blocks. They are driven by the symmetric part
/// of applied minus internal stress, divided by the effective mass l_j^2 M / (4 A).
/// (12): then updates the internal stress of free blocks by plane strain elasticity.
/// Deformable runs only. rates: 1/T (4, range) strain rates of the range before the
/// step, which damp_unbalanced may have changed; null if no material damps vibration.
/// The energy that this damping takes is added to step.damped
/// (docs/cracks.md#damping-of-vibration).
void update_strain(Blocks& blocks, BlockRange range, const Settings& settings,
                   const StepMotion& step, const double* rates,
                   const Kernels& chosen = kernels());

/// Returns whether the vibration of blocks of some material is damped (MDAMP).
bool damps_vibration(const Settings& settings);

/// (3), (13)-(15): updates centroids, angles, deformation gradients and corners of free
/// and driven blocks. The gradient becomes R (I + strain rate dt) gradient, where R is
/// the Cayley rotation of spin dt. R also turns stress and strain rate. Reads
/// bounds.longest, advances bounds.path.
Displacement move_corners(Blocks& blocks, BlockRange range, MotionBounds& bounds,
                          const Settings& settings, double dt,
                          const Kernels& chosen = kernels());

}  // namespace blocks::dynamics
