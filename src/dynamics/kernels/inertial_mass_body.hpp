// Masses that are scaled by MSCALE, for the motion kernels.
#pragma once

#include "dynamics/kernels/motion_kernel.hpp"
#include "dynamics/kernels/simd.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Returns the inertial masses of a pack of blocks, [M].
template <class Lanes>
BLOCKS_INLINE Pack inertial_mass(const BlockColumns& blocks, int b, Lanes lanes) {
  const Pack mass = load(blocks.mass + b, lanes);
  return blocks.scale == nullptr ? mass : mass * load(blocks.scale + b, lanes);
}

/// Returns the acceleration of blocks with inertial masses from that with their masses.
template <class Lanes>
BLOCKS_INLINE Pack scaled(const BlockColumns& blocks, Pack acceleration, int b,
                          Lanes lanes) {
  return blocks.scale == nullptr ? acceleration
                                 : acceleration / load(blocks.scale + b, lanes);
}
template <class Lanes>
BLOCKS_INLINE Points scaled(const BlockColumns& blocks, const Points& acceleration,
                            int b, Lanes lanes) {
  return blocks.scale == nullptr ? acceleration
                                 : acceleration / twice(load(blocks.scale + b, lanes));
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
