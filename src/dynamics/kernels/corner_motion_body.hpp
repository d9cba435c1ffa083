// Computes the corners of blocks for motion_kernel_body.hpp. A register contains x and
// y of a few corners in the order of memory.
#pragma once

#include "dynamics/kernels/motion_kernel.hpp"
#include "dynamics/kernels/simd.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

template <class Number> BLOCKS_INLINE Number* at_corner(Number* corners, int c) {
  return corners + 2 * static_cast<std::ptrdiff_t>(c);
}

/// Returns whether the pack is full and all its blocks move and have four corners.
/// Their corners then fill eight registers, in the order of the blocks.
template <class Lanes>
BLOCKS_INLINE bool all_have_four_corners(const BlockColumns& blocks, int b,
                                         Lanes lanes) {
  if (lanes.count < width)
    return false;
  const int* const first = blocks.first_corner + b;
  const Ints unlike =
      load_ints(first + 1, AllLanes{}) - load_ints(first, AllLanes{}) - 4;
  return !any(unlike | (load_ints(blocks.fixity + b, AllLanes{}) & ~driven_bit));
}

/// Calls work(count, c) for the corners of a block, `count` of them from corner c on.
/// It takes as many at a time as a register has, then fewer until all are done.
template <class Work>
BLOCKS_INLINE void each_piece(int first, int last, const Work& work) {
  int c = first;
  for (; c + width / 2 <= last; c += width / 2)
    work(std::integral_constant<int, width / 2>(), c);
  if constexpr (width > 4)
    if (c + 2 <= last) {
      work(std::integral_constant<int, 2>(), c);
      c += 2;
    }
  if constexpr (width > 2)
    if (c < last)
      work(std::integral_constant<int, 1>(), c);
}

/// Returns y, x of each corner.
template <std::size_t... k, class Corners>
BLOCKS_INLINE Corners swapped(Corners x, std::index_sequence<k...>) {
  return __builtin_shufflevector(x, x, (k ^ 1)...);
}

/// Computes the corners of a pack of blocks.
struct CornerMotion {
  alignas(64) double g11[width], g12[width], g21[width], g22[width];  ///< gradient
  alignas(64) double centroid[2 * width];  ///< [L] x, y of each block

  /// corner = centroid + gradient arm for a few corners of block k of the pack.
  /// `numbers` is twice the number of these corners.
  template <int numbers>
  BLOCKS_INLINE void move(int k, const double* arm_at, double* corner_at) const {
    constexpr auto each = std::make_index_sequence<numbers>();
    const auto same = in_turn(g11[k], g22[k], each);
    const auto cross = in_turn(g12[k], g21[k], each);
    const auto from = in_turn(centroid[2 * k], centroid[2 * k + 1], each);
    const Numbers<numbers> arm = load<numbers>(arm_at);
    store<numbers>(corner_at, from + (same * arm + cross * swapped(arm, each)));
  }
};

/// (13)-(15) for the corners of the moving blocks of a pack, which begins with block b.
template <class Lanes>
BLOCKS_INLINE void move_corners(const BlockColumns& blocks, int b, Lanes lanes,
                                const Tensor& gradient, const Points& centroid) {
  CornerMotion motion;
  store<width>(motion.g11, gradient[0]), store<width>(motion.g12, gradient[1]);
  store<width>(motion.g21, gradient[2]), store<width>(motion.g22, gradient[3]);
  store_columns(motion.centroid, 0, AllLanes{}, centroid);

  if (all_have_four_corners(blocks, b, lanes)) {
    const int c = blocks.first_corner[b];
    const double* const arms = at_corner(blocks.arm, c);
    double* const corners = at_corner(blocks.corner, c);
    // This loop is not unrolled. It then loads the numbers of a block from memory,
    // which is faster than shuffles.
#pragma GCC unroll 1
    for (int k = 0; k < width; ++k)
      for (int i = k * 8 / width; i < (k + 1) * 8 / width; ++i)
        motion.move<width>(k, arms + i * width, corners + i * width);
    return;
  }
  for (int k = 0; k < lanes.count; ++k)
    if ((static_cast<int>(blocks.fixity[b + k]) & ~driven_bit) == 0)
      each_piece(
          blocks.first_corner[b + k], blocks.first_corner[b + k + 1],
          [&](auto corners, int c) __attribute__((always_inline)) {
            motion.move<2 * corners>(k, at_corner(blocks.arm, c),
                                     at_corner(blocks.corner, c));
          });
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
