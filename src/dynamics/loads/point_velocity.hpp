// The velocity of a material point of a block.
#pragma once

#include "model/blocks.hpp"

namespace blocks::dynamics {

/// Returns the velocity (14) of the material point of block b at `arm` from its
/// centroid, [L/T]. The strain rates are included; they are zero for a rigid block.
inline Vec2 point_velocity(const Blocks& blocks, int b, const Vec2& arm) {
  const auto rate = blocks.strain_rate.col(b);
  const double spin = blocks.spin[b];
  return {blocks.velocity(0, b) + rate[0] * arm.x() + (rate[1] - spin) * arm.y(),
          blocks.velocity(1, b) + (rate[2] + spin) * arm.x() + rate[3] * arm.y()};
}

}  // namespace blocks::dynamics
