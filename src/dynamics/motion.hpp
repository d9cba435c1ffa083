// Equations of motion, strain rates, internal stress and corners (MOTION and STRESS,
// report 2.1, 2.3, 2.4; rules 1, 3-6).
#pragma once

#include "dynamics/acting_lanes.hpp"
#include "dynamics/block_motion.hpp"
#include "model/model.hpp"

namespace blocks::dynamics {

/// Blocks first .. last - 1: what one thread moves.
struct BlockRange {
  int first = 0, last = 0;
};
inline BlockRange all_of(const Blocks& blocks) { return {0, blocks.size()}; }

/// What one step of motion did.
struct Displacement {
  double largest = 0.0;      ///< [L] no corner has moved by more (UDMAX): way of the
                             ///< centroid and change of the longest arm
  int block = -1;            ///< the block of which that is said
  double way = 0.0;          ///< [L] no block's way (Swing) has grown by more
  bool finite = true;        ///< false: some corner is no longer a number
  bool left_domain = false;  ///< some corner lies outside the domain
  double strongest = 0.0;    ///< [F] largest elastic normal force of a contact

  /// With what became of blocks behind these.
  void include(const Displacement& others);
};

/// Force and moment of the contacts in the lanes, in the order of the list; in
/// deformable runs the applied stress (9) too: f_i x_j over the area. Added to what
/// loads and planes do where these have pushed, else alone.
void sum_contacts(Blocks& blocks, const ActingLanes& acting, BlockRange range,
                  bool pushed, bool rigid);

/// (1), (2): velocities and spin of free blocks from force, moment and gravity.
void update_velocities(Blocks& blocks, BlockRange range, const Vec2& gravity, double dt,
                       const MotionArithmetic& by = motion_arithmetic());

/// (10): strain rates of free blocks, driven by the symmetric part of applied -
/// internal stress over the effective mass l_j^2 M / (4 A); then (12): their internal
/// stress by plane strain elasticity. Deformable runs only.
void update_strain(Blocks& blocks, BlockRange range, const Settings& settings,
                   double dt, const MotionArithmetic& by = motion_arithmetic());

/// (3), (13)-(15): centroids, angles and corners; arm = R (I + strain rate dt) arm with
/// the Cayley rotation R of spin dt, which also turns stress and strain rate. Adds to
/// swing.
Displacement move_blocks(Blocks& blocks, BlockRange range, Swing& swing,
                         const Settings& settings, double dt,
                         const MotionArithmetic& by = motion_arithmetic());

}  // namespace blocks::dynamics
