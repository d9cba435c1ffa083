// The choice between free and other blocks, for the motion kernels.
#pragma once

#include "dynamics/kernels/motion_kernel.hpp"
#include "dynamics/kernels/simd.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Returns the lanes that have a free block.
template <class Lanes>
BLOCKS_INLINE Mask free_lanes(const BlockColumns& blocks, int b, Lanes lanes) {
  return __builtin_convertvector(load_ints(blocks.fixity + b, lanes) == 0, Mask);
}

/// Returns `changed` for free blocks and `kept` for the others.
BLOCKS_INLINE Points select(Mask free, const Points& changed, const Points& kept) {
  return {low_turns(free, free, EachLane()) ? changed.part[0] : kept.part[0],
          high_turns(free, free, EachLane()) ? changed.part[1] : kept.part[1]};
}
BLOCKS_INLINE Tensor select(Mask free, const Tensor& changed, const Tensor& kept) {
  Tensor all;
  for (int i = 0; i < 4; ++i)
    all[i] = free ? changed[i] : kept[i];
  return all;
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
