// Sides that let waves out (QUIET, docs/waves.md): dashpots at the two corners of a
// side, and the constant forces that have replaced the reaction of a fixed block.
#pragma once

#include "model/model.hpp"

namespace blocks::dynamics {

/// Numbers of the corner where a side begins and of the next one.
struct QuietEnds {
  int first, second;
};
QuietEnds ends_of(const Blocks& blocks, const QuietSide& quiet);

/// The dashpots at each corner of a side. Their force is
/// -(normal p p^T + along a a^T) v. The vector a runs along the side, and p is at right
/// angles to it. Both are as long as the side, so the coefficients are in [F T/L^3].
struct Dashpots {
  Vec2 a, p;
  double normal, along;
};
Dashpots dashpots_of(const Blocks& blocks, const QuietSide& quiet);

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

}  // namespace blocks::dynamics
