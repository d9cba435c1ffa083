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

/// Blocks begin .. end - 1.
struct BlockRange {
  int begin = 0, end = 0;
};
inline BlockRange all_of(const Blocks& blocks) { return {0, blocks.size()}; }

/// How far blocks moved in a step.
struct Displacement {
  double largest = 0.0;  ///< [L] UDMAX: no corner moved by more. It is the distance
                         ///< moved by the centroid plus the change of the longest arm.
  int block = -1;        ///< the first block that reached `largest`
  double bound = 0.0;    ///< [L] no MotionBounds::moved grew by more
  bool finite = true;    ///< false: some corner is no longer a number
  bool left_domain = false;  ///< some corner lies outside the domain

  /// Joins what other blocks did.
  void include(const Displacement& others);
};

/// Sums the forces of contacts block by block, in the order of the pairs, and moves all
/// blocks by one step. If `loaded`, blocks.force, moment and applied hold the loads;
/// otherwise they are overwritten. Reads forces of pairs and settings; writes blocks
/// and bounds.
Displacement move_blocks(Blocks& blocks, const Settings& settings, double dt,
                         bool loaded, const ContactArrays& contacts,
                         MotionBounds& bounds, const std::vector<int>& shares,
                         Workers& workers, std::vector<Displacement>& threads);

// The parts of move_blocks, for a range of blocks.

/// (9): force and moment of the contacts; in deformable runs the applied stress, the
/// sum of f_i x_j over the area, too.
void sum_contacts(Blocks& blocks, const ContactArrays& contacts, BlockRange range,
                  bool loaded, bool rigid);

/// (1), (2): velocities and spin of free blocks from force, moment and gravity.
void update_velocities(Blocks& blocks, BlockRange range, const Vec2& gravity, double dt,
                       const Kernels& by = kernels());

/// (10): strain rates of free blocks, driven by the symmetric part of applied -
/// internal stress over the effective mass l_j^2 M / (4 A); then (12): their internal
/// stress by plane strain elasticity. Deformable runs only.
void update_strain(Blocks& blocks, BlockRange range, const Settings& settings,
                   double dt, const Kernels& by = kernels());

/// (3), (13)-(15): centroids, angles and corners; arm = R (I + strain rate dt) arm with
/// the Cayley rotation R of spin dt, which also turns stress and strain rate. Adds to
/// the bounds.
Displacement move_corners(Blocks& blocks, BlockRange range, const MotionBounds& bounds,
                          const Settings& settings, double dt,
                          const Kernels& by = kernels());

}  // namespace blocks::dynamics
