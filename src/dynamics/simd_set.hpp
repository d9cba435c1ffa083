// Vectors for bodies that are compiled once for each instruction set, in a namespace of
// its own. A Set is as many numbers as one register holds, one of each block, and its
// operators act lane by lane.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#define BLOCKS_INLINE [[gnu::always_inline]] inline

namespace blocks::dynamics::BLOCKS_LANES {
namespace {

/// So many numbers side by side.
template <int count> struct VectorOf {
  typedef double type __attribute__((vector_size(count * sizeof(double))));
};
template <int count> using Numbers = typename VectorOf<count>::type;

constexpr int width = BLOCKS_LANES_AT_ONCE;
using Set = Numbers<width>;
using Mask = decltype(Set{} < Set{});

template <int count> BLOCKS_INLINE Numbers<count> load(const double* from) {
  Numbers<count> x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}
template <int count> BLOCKS_INLINE void store(double* to, Numbers<count> x) {
  __builtin_memcpy(to, &x, sizeof x);
}

/// As many blocks as a Set has lanes; or the last few of a range, with zeros in the
/// other lanes.
struct AllLanes {
  static constexpr int count = width;
};
struct FewLanes {
  int count;
};

/// Calls work(b, lanes) for the blocks b .. b + lanes.count - 1 of each set.
template <class Work>
BLOCKS_INLINE void each_set(int first, int last, const Work& work) {
  int b = first;
  for (; b + width <= last; b += width)
    work(b, AllLanes{});
  if (b < last)
    work(b, FewLanes{last - b});
}

/// A number of each block.
template <class Lanes> BLOCKS_INLINE Set load(const double* column, Lanes lanes) {
  Set x = {};
  __builtin_memcpy(&x, column, lanes.count * sizeof(double));
  return x;
}
template <class Lanes> BLOCKS_INLINE void store(double* column, Lanes lanes, Set x) {
  __builtin_memcpy(column, &x, lanes.count * sizeof(double));
}

using EachLane = std::make_index_sequence<width>;
/// Of two sets in a row: every other number, from the first on or from the second.
template <std::size_t... k>
BLOCKS_INLINE Set even(Set a, Set b, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, b, (2 * k)...);
}
template <std::size_t... k>
BLOCKS_INLINE Set odd(Set a, Set b, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, b, (2 * k + 1)...);
}
/// Of two sets: number by number in turn, the lower lanes or the upper ones.
template <std::size_t... k>
BLOCKS_INLINE Set low_turns(Set a, Set b, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, b, (k / 2 + k % 2 * width)...);
}
template <std::size_t... k>
BLOCKS_INLINE Set high_turns(Set a, Set b, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, b, ((width + k) / 2 + k % 2 * width)...);
}

/// Rows of a set of columns of a matrix.
template <int rows> struct Rows {
  Set row[rows];
  BLOCKS_INLINE Set& operator[](int i) { return row[i]; }
  BLOCKS_INLINE const Set& operator[](int i) const { return row[i]; }
};
using Point = Rows<2>;   ///< x, y
using Tensor = Rows<4>;  ///< 11, 12, 21, 22

/// Columns of two or four numbers, as they stand in the memory, to rows and back.
BLOCKS_INLINE Point rows_of(Set a, Set b) {
  return {even(a, b, EachLane()), odd(a, b, EachLane())};
}
BLOCKS_INLINE Point columns_of(Set x, Set y) {
  return {low_turns(x, y, EachLane()), high_turns(x, y, EachLane())};
}
BLOCKS_INLINE Point rows_of(const Point& columns) {
  return rows_of(columns[0], columns[1]);
}
BLOCKS_INLINE Point columns_of(const Point& rows) {
  return columns_of(rows[0], rows[1]);
}
BLOCKS_INLINE Tensor rows_of(const Tensor& columns) {
  const Point low = rows_of(columns[0], columns[1]);  // 11 and 21; 12 and 22
  const Point high = rows_of(columns[2], columns[3]);
  const Point first = rows_of(low[0], high[0]), second = rows_of(low[1], high[1]);
  return {first[0], second[0], first[1], second[1]};
}
BLOCKS_INLINE Tensor columns_of(const Tensor& rows) {
  const Point first = columns_of(rows[0], rows[2]);
  const Point second = columns_of(rows[1], rows[3]);
  const Point low = columns_of(first[0], second[0]);
  const Point high = columns_of(first[1], second[1]);
  return {low[0], low[1], high[0], high[1]};
}

/// Columns b .. of a matrix.
template <int rows, class Lanes>
BLOCKS_INLINE Rows<rows> load_columns(const double* matrix, int b, Lanes lanes) {
  const double* from = matrix + static_cast<std::ptrdiff_t>(rows) * b;
  double few[rows * width];
  if constexpr (std::is_same_v<Lanes, FewLanes>) {
    __builtin_memset(few, 0, sizeof few);
    __builtin_memcpy(few, from, rows * lanes.count * sizeof(double));
    from = few;
  }
  Rows<rows> columns;
  for (int i = 0; i < rows; ++i)
    columns[i] = load<width>(from + i * width);
  return rows_of(columns);
}
template <int rows, class Lanes>
BLOCKS_INLINE void store_columns(double* matrix, int b, Lanes lanes,
                                 const Rows<rows>& of) {
  double* const to = matrix + static_cast<std::ptrdiff_t>(rows) * b;
  const Rows<rows> columns = columns_of(of);
  if constexpr (std::is_same_v<Lanes, FewLanes>) {
    __builtin_memcpy(to, columns.row, rows * lanes.count * sizeof(double));
  } else {
    for (int i = 0; i < rows; ++i)
      store<width>(to + i * width, columns[i]);
  }
}

BLOCKS_INLINE Set absolute(Set x) {
  return reinterpret_cast<Set>(reinterpret_cast<Mask>(x) & 0x7fffffffffffffff);
}
BLOCKS_INLINE Set root(Set x) {
  for (int k = 0; k < width; ++k)
    x[k] = __builtin_sqrt(x[k]);
  return x;
}
BLOCKS_INLINE bool any(Mask yes) {
  typedef signed char Marks __attribute__((vector_size(width)));
  const Marks marks = __builtin_convertvector(yes, Marks);
  unsigned long long word = 0;
  __builtin_memcpy(&word, &marks, width);
  return word != 0;
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_LANES
