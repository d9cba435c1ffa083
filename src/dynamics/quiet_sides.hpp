// Sides that let waves out (QUIET, docs/waves.md): dashpots at the two corners of a
// side, and the constant forces that have replaced the reaction of a fixed block.
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// The dashpot forces of a quiet side, which act at its two corners.
struct QuietForces {
  Vec2 arm[2];       ///< [L] from the centroid
  Vec2 velocity[2];  ///< [L/T] of the corners
  Vec2 force[2];     ///< [F]
};
/// Returns -rho L / 2 (cp v_n n + cs v_t t) at each corner. The density is that of the
/// block, and L is the present length of the side.
QuietForces forces_of(const Blocks& blocks, const QuietSide& quiet);

/// Adds dashpots and constant forces of all quiet sides to force, moment and applied.
void add_quiet_sides(Blocks& blocks, const std::vector<QuietSide>& sides);

/// The power of all quiet sides on their blocks, [F L/T].
struct QuietPower {
  double constant = 0.0;  ///< of the constant forces
  double dashpots = 0.0;  ///< of the dashpots, never positive
};
QuietPower power_of_quiet_sides(const Model& model);

/// Returns the largest rate at which dashpots slow down a motion of a free block,
/// [1/T]. A step of 2 over that rate is unstable, with or without other forces.
/// `sides` may have quiet sides of any blocks; only those of block b count.
double decay_rate(const Blocks& blocks, bool rigid, int b,
                  const std::vector<QuietSide>& sides);

/// Makes a side quiet. If it is quiet already, its wave speeds are replaced, and its
/// constant forces stay. A fixed or driven block becomes free. The force and moment
/// that held it are added to the constant forces of the side. A deformable block also
/// gets the stress that is in equilibrium with the forces on it. Forces and stresses
/// are those of the last step. Returns the force that held the block, [F], and 0 for a
/// free block. The block must be inside the domain and not removed.
Vec2 make_quiet(Model& model, const QuietSide& quiet);

}  // namespace blocks::dynamics
