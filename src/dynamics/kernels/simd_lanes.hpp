// Additions to simd.hpp for contacts: numbers gathered by index, and conditions as
// bits. Included once for each instruction set.
#pragma once

#include <cstddef>
#include <utility>
#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "dynamics/kernels/simd.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

BLOCKS_INLINE Pack all_of(double x) { return Pack{} + x; }
BLOCKS_INLINE Pack load(const double* row, int first) {
  return *reinterpret_cast<const Pack*>(row + first);
}
BLOCKS_INLINE void store(double* row, int first, Pack x) {
  *reinterpret_cast<Pack*>(row + first) = x;
}
/// A condition for each lane. Bit k belongs to lane k.
using Bits = unsigned;
constexpr Bits every = (1U << width) - 1;

#if BLOCKS_LANES_AT_ONCE == 8
using Choice = __mmask8;
BLOCKS_INLINE Choice choice_of(Bits yes) { return static_cast<Choice>(yes); }
BLOCKS_INLINE Pack where(Choice yes, Pack x) {
  return reinterpret_cast<Pack>(_mm512_maskz_mov_pd(yes, reinterpret_cast<__m512d>(x)));
}
BLOCKS_INLINE Pack where(Choice yes, Pack x, Pack other) {
  return reinterpret_cast<Pack>(_mm512_mask_blend_pd(
      yes, reinterpret_cast<__m512d>(other), reinterpret_cast<__m512d>(x)));
}
BLOCKS_INLINE Bits less(Pack a, Pack b) {
  return _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a), reinterpret_cast<__m512d>(b),
                            _CMP_LT_OS);
}
BLOCKS_INLINE Bits zero(Pack a) {
  return _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a), _mm512_setzero_pd(),
                            _CMP_EQ_OQ);
}
#else
using Choice = Mask;
template <std::size_t... lane>
BLOCKS_INLINE Choice choice_of(Bits yes, std::index_sequence<lane...>) {
  const Choice bit = {(1LL << lane)...};
  return (bit & (Choice{} + static_cast<long long>(yes))) != 0;
}
BLOCKS_INLINE Choice choice_of(Bits yes) { return choice_of(yes, EachLane()); }
BLOCKS_INLINE Pack where(Choice yes, Pack x) { return yes ? x : Pack{}; }
BLOCKS_INLINE Pack where(Choice yes, Pack x, Pack other) { return yes ? x : other; }
BLOCKS_INLINE Bits bits_of(Mask yes) {
#if defined(__AVX__) && BLOCKS_LANES_AT_ONCE == 4
  return static_cast<Bits>(_mm256_movemask_pd(reinterpret_cast<__m256d>(yes)));
#elif defined(__SSE2__) && BLOCKS_LANES_AT_ONCE == 2
  return static_cast<Bits>(_mm_movemask_pd(reinterpret_cast<__m128d>(yes)));
#else
  Bits bits = 0;
  for (int k = 0; k < width; ++k)
    bits |= (yes[k] != 0 ? 1U : 0U) << k;
  return bits;
#endif
}
BLOCKS_INLINE Bits less(Pack a, Pack b) { return bits_of(a < b); }
BLOCKS_INLINE Bits zero(Pack a) { return bits_of(a == 0.0); }
#endif

/// Gathers one number for each lane.
template <std::size_t... lane>
BLOCKS_INLINE Pack gather(const double* row, const int* index,
                          std::index_sequence<lane...>) {
  return Pack{row[index[lane]]...};
}
BLOCKS_INLINE Pack gather(const double* row, const int* index) {
  return gather(row, index, EachLane());
}

using Pair = Numbers<2>;
/// Gathers two numbers for each lane: rows r and r + 1 of column index[k] of a matrix.
template <int rows>
BLOCKS_INLINE Point gather_point(const double* matrix, const int* index, int r = 0) {
  const auto at = [&](int k) __attribute__((always_inline)) {
    const double* const p = matrix + static_cast<std::ptrdiff_t>(rows) * index[k] + r;
    return Pair{p[0], p[1]};
  };
#if BLOCKS_LANES_AT_ONCE == 8
  // One register has lanes 0, 2, 4, 6, the other lanes 1, 3, 5, 7. Only x and y have to
  // be shuffled.
  const auto four = [&](int k) __attribute__((always_inline)) {
    const auto part = [&](int i) __attribute__((always_inline)) {
      return reinterpret_cast<__m128d>(at(i));
    };
    __m512d all = _mm512_castpd128_pd512(part(k));
    all = _mm512_mask_broadcast_f64x2(all, 0x0C, part(k + 2));
    all = _mm512_mask_broadcast_f64x2(all, 0x30, part(k + 4));
    all = _mm512_mask_broadcast_f64x2(all, 0xC0, part(k + 6));
    return reinterpret_cast<Pack>(all);
  };
  const Pack even = four(0), odd = four(1);
  return {__builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14),
          __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15)};
#elif BLOCKS_LANES_AT_ONCE == 4
  const auto two = [&](int k) __attribute__((always_inline)) {
    return __builtin_shufflevector(at(k), at(k + 2), 0, 1, 2, 3);
  };
  return {__builtin_shufflevector(two(0), two(1), 0, 4, 2, 6),
          __builtin_shufflevector(two(0), two(1), 1, 5, 3, 7)};
#else
  static_assert(width == 2);
  return {__builtin_shufflevector(at(0), at(1), 0, 2),
          __builtin_shufflevector(at(0), at(1), 1, 3)};
#endif
}

/// Stores two numbers of each lane side by side: those of lane k at to + k stride.
BLOCKS_INLINE void store_point(double* to, int stride, Pack x, Pack y) {
  const auto put = [&](int k, Pair pair) __attribute__((always_inline)) {
    *reinterpret_cast<Pair*>(to + k * stride) = pair;
  };
#if BLOCKS_LANES_AT_ONCE == 8
  const Pack even = __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
  const Pack odd = __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
  put(0, __builtin_shufflevector(even, even, 0, 1));
  put(1, __builtin_shufflevector(odd, odd, 0, 1));
  put(2, __builtin_shufflevector(even, even, 2, 3));
  put(3, __builtin_shufflevector(odd, odd, 2, 3));
  put(4, __builtin_shufflevector(even, even, 4, 5));
  put(5, __builtin_shufflevector(odd, odd, 4, 5));
  put(6, __builtin_shufflevector(even, even, 6, 7));
  put(7, __builtin_shufflevector(odd, odd, 6, 7));
#elif BLOCKS_LANES_AT_ONCE == 4
  const Pack even = __builtin_shufflevector(x, y, 0, 4, 2, 6);
  const Pack odd = __builtin_shufflevector(x, y, 1, 5, 3, 7);
  put(0, __builtin_shufflevector(even, even, 0, 1));
  put(1, __builtin_shufflevector(odd, odd, 0, 1));
  put(2, __builtin_shufflevector(even, even, 2, 3));
  put(3, __builtin_shufflevector(odd, odd, 2, 3));
#else
  put(0, __builtin_shufflevector(x, y, 0, 2));
  put(1, __builtin_shufflevector(x, y, 1, 3));
#endif
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
