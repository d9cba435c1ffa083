// One force at one point of a block: the only place where forces are summed.
#pragma once

#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Adds force f [F] acting at `arm` [L] from the centroid of block b: resultant, moment
/// (anticlockwise positive) and the sums f_i x_j of (9).
inline void add_force(Blocks& blocks, int b, const Vec2& arm, const Vec2& f) {
  blocks.force.col(b) += f;
  blocks.moment[b] += arm.x() * f.y() - arm.y() * f.x();
  blocks.applied.col(b) += Eigen::Vector4d(f.x() * arm.x(), f.x() * arm.y(),
                                           f.y() * arm.x(), f.y() * arm.y());
}

}  // namespace blocks::dynamics
