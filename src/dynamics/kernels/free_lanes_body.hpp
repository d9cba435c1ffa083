// The choice of the blocks that forces change or that move, for the motion kernels.
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

/// Returns the lanes that have a free or driven block.
template <class Lanes>
BLOCKS_INLINE Mask moving_lanes(const BlockColumns& blocks, int b, Lanes lanes) {
  return __builtin_convertvector(
      (load_ints(blocks.fixity + b, lanes) & ~driven_bit) == 0, Mask);
}

/// Returns `changed` for the chosen blocks and `kept` for the others.
BLOCKS_INLINE Points select(Mask chosen, const Points& changed, const Points& kept) {
  return {low_turns(chosen, chosen, EachLane()) ? changed.part[0] : kept.part[0],
          high_turns(chosen, chosen, EachLane()) ? changed.part[1] : kept.part[1]};
}
BLOCKS_INLINE Tensor select(Mask chosen, const Tensor& changed, const Tensor& kept) {
  Tensor all;
  for (int i = 0; i < 4; ++i)
    all[i] = chosen ? changed[i] : kept[i];
  return all;
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
