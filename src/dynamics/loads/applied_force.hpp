// Adds one force at one point of a block: of planes, loads and INSITU.
#pragma once

#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Adds the force f [F] to the resultant, the moment (anticlockwise positive) and the
/// sums f_i x_j of (9) of block b. The force acts at `arm` [L] from the centroid.
inline void add_force(Blocks& blocks, int b, const Vec2& arm, const Vec2& f) {
  // Scalars are written one at a time: a vector load of two doubles that were stored
  // separately stalls the processor.
  const double x = arm.x(), y = arm.y(), fx = f.x(), fy = f.y();
  double* const force = &blocks.force(0, b);
  double* const sums = &blocks.applied(0, b);
  force[0] += fx;
  force[1] += fy;
  blocks.moment[b] += x * fy - y * fx;
  sums[0] += fx * x;
  sums[1] += fx * y;
  sums[2] += fy * x;
  sums[3] += fy * y;
}

}  // namespace blocks::dynamics
