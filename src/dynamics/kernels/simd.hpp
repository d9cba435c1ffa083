// SIMD vectors for the kernels, which are compiled once for each instruction set in a
// namespace of its own. A Pack has as many numbers as a register, usually one of each
// block. Its operators act lane by lane. Kernels call nothing that is compiled
// elsewhere, so that the linker cannot pick a function of a wider instruction set for
// other code.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#define BLOCKS_INLINE [[gnu::always_inline]] inline

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// A vector of `count` doubles.
template <int count> struct VectorOf {
  typedef double type __attribute__((vector_size(count * sizeof(double))));
};
template <int count> using Numbers = typename VectorOf<count>::type;

constexpr int width = BLOCKS_LANES_AT_ONCE;
using Pack = Numbers<width>;
using Mask = decltype(Pack{} < Pack{});

template <int count> BLOCKS_INLINE Numbers<count> load(const double* from) {
  typedef Numbers<count> Anywhere __attribute__((aligned(8), may_alias));
  return *reinterpret_cast<const Anywhere*>(from);
}
template <int count> BLOCKS_INLINE void store(double* to, Numbers<count> x) {
  __builtin_memcpy(to, &x, sizeof x);
}

/// The lanes of a Pack in use: all of them, or those of the last few blocks of a range,
/// with zeros in the other lanes.
struct AllLanes {
  static constexpr int count = width;
};
struct FewLanes {
  int count;
};

/// Calls work(b, lanes) for each pack of blocks. The pack has the blocks of the
/// half-open range [b, b + lanes.count).
template <class Work>
BLOCKS_INLINE void each_pack(int first, int last, const Work& work) {
  int b = first;
  for (; b + width <= last; b += width)
    work(b, AllLanes{});
  if (b < last)
    work(b, FewLanes{last - b});
}

/// Loads one number for each block.
template <class Lanes> BLOCKS_INLINE Pack load(const double* column, Lanes lanes) {
  Pack x = {};
  __builtin_memcpy(&x, column, lanes.count * sizeof(double));
  return x;
}
template <class Lanes> BLOCKS_INLINE void store(double* column, Lanes lanes, Pack x) {
  __builtin_memcpy(column, &x, lanes.count * sizeof(double));
}

using EachLane = std::make_index_sequence<width>;
/// Returns 0, 1, 2 ...
template <std::size_t... k>
BLOCKS_INLINE Mask number_of_each_lane(std::index_sequence<k...>) {
  return Mask{k...};
}
/// Return every other number of two packs taken together, starting with the first or
/// with the second.
template <class Vector, std::size_t... k>
BLOCKS_INLINE Vector even(Vector a, Vector b, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, b, (2 * k)...);
}
template <class Vector, std::size_t... k>
BLOCKS_INLINE Vector odd(Vector a, Vector b, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, b, (2 * k + 1)...);
}
/// Interleave the numbers of the lower lanes of two packs, or those of the upper lanes.
template <class Vector, std::size_t... k>
BLOCKS_INLINE Vector low_turns(Vector a, Vector b, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, b, (k / 2 + k % 2 * width)...);
}
template <class Vector, std::size_t... k>
BLOCKS_INLINE Vector high_turns(Vector a, Vector b, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, b, ((width + k) / 2 + k % 2 * width)...);
}

/// `rows` numbers for each block, in the order of memory: block by block. They fill
/// `rows` registers.
template <int rows> struct Columns { Pack part[rows]; };
/// The same numbers row by row: one register for each row.
template <int rows> struct Rows {
  Pack row[rows];
  BLOCKS_INLINE Pack& operator[](int i) { return row[i]; }
  BLOCKS_INLINE const Pack& operator[](int i) const { return row[i]; }
};
using Point = Rows<2>;   ///< x, y
using Tensor = Rows<4>;  ///< 11, 12, 21, 22

BLOCKS_INLINE Rows<2> rows_of(Pack a, Pack b) {
  return {even(a, b, EachLane()), odd(a, b, EachLane())};
}
BLOCKS_INLINE Columns<2> columns_of(Pack x, Pack y) {
  return {low_turns(x, y, EachLane()), high_turns(x, y, EachLane())};
}
BLOCKS_INLINE Rows<2> rows_of(const Columns<2>& columns) {
  return rows_of(columns.part[0], columns.part[1]);
}
BLOCKS_INLINE Columns<2> columns_of(const Rows<2>& rows) {
  return columns_of(rows[0], rows[1]);
}
#if BLOCKS_LANES_AT_ONCE == 4
// A four by four transpose takes half the instructions of the general code below.
template <class To> BLOCKS_INLINE To transposed(const Pack* m) {
  const Pack a = __builtin_shufflevector(m[0], m[1], 0, 4, 2, 6);
  const Pack b = __builtin_shufflevector(m[0], m[1], 1, 5, 3, 7);
  const Pack c = __builtin_shufflevector(m[2], m[3], 0, 4, 2, 6);
  const Pack d = __builtin_shufflevector(m[2], m[3], 1, 5, 3, 7);
  return {__builtin_shufflevector(a, c, 0, 1, 4, 5),
          __builtin_shufflevector(b, d, 0, 1, 4, 5),
          __builtin_shufflevector(a, c, 2, 3, 6, 7),
          __builtin_shufflevector(b, d, 2, 3, 6, 7)};
}
BLOCKS_INLINE Rows<4> rows_of(const Columns<4>& columns) {
  return transposed<Rows<4>>(columns.part);
}
BLOCKS_INLINE Columns<4> columns_of(const Rows<4>& rows) {
  return transposed<Columns<4>>(rows.row);
}
#else
BLOCKS_INLINE Rows<4> rows_of(const Columns<4>& columns) {
  const Rows<2> low =
      rows_of(columns.part[0], columns.part[1]);  // rows 0 and 2; 1 and 3
  const Rows<2> high = rows_of(columns.part[2], columns.part[3]);
  const Rows<2> a = rows_of(low[0], high[0]), b = rows_of(low[1], high[1]);
  return {a[0], b[0], a[1], b[1]};
}
BLOCKS_INLINE Columns<4> columns_of(const Rows<4>& rows) {
  const Columns<2> a = columns_of(rows[0], rows[2]), b = columns_of(rows[1], rows[3]);
  const Columns<2> low = columns_of(a.part[0], b.part[0]);
  const Columns<2> high = columns_of(a.part[1], b.part[1]);
  return {low.part[0], low.part[1], high.part[0], high.part[1]};
}
#endif

/// Loads the columns of a matrix that belong to the blocks from b on.
template <int rows, class Lanes>
BLOCKS_INLINE Columns<rows> load_columns(const double* matrix, int b, Lanes lanes) {
  const double* from = matrix + static_cast<std::ptrdiff_t>(rows) * b;
  double few[rows * width];
  if constexpr (std::is_same_v<Lanes, FewLanes>) {
    __builtin_memset(few, 0, sizeof few);
    __builtin_memcpy(few, from, rows * lanes.count * sizeof(double));
    from = few;
  }
  Columns<rows> columns;
  for (int i = 0; i < rows; ++i)
    columns.part[i] = load<width>(from + i * width);
  return columns;
}
template <int rows, class Lanes>
BLOCKS_INLINE void store_columns(double* matrix, int b, Lanes lanes,
                                 const Columns<rows>& columns) {
  double* const to = matrix + static_cast<std::ptrdiff_t>(rows) * b;
  if constexpr (std::is_same_v<Lanes, FewLanes>) {
    __builtin_memcpy(to, columns.part, rows * lanes.count * sizeof(double));
  } else {
    for (int i = 0; i < rows; ++i)
      store<width>(to + i * width, columns.part[i]);
  }
}
template <int rows, class Lanes>
BLOCKS_INLINE Rows<rows> load_rows(const double* matrix, int b, Lanes lanes) {
  return rows_of(load_columns<rows>(matrix, b, lanes));
}
template <int rows, class Lanes>
BLOCKS_INLINE void store_rows(double* matrix, int b, Lanes lanes,
                              const Rows<rows>& numbers) {
  store_columns(matrix, b, lanes, columns_of(numbers));
}

// x and y of each block are often processed in the order of memory.
using Points = Columns<2>;
/// Returns a number of each block twice, to be used with its x and y.
BLOCKS_INLINE Points twice(Pack x) { return columns_of(x, x); }
/// Returns x, y, x, y ..., as many numbers as the sequence has.
template <std::size_t... k>
BLOCKS_INLINE auto in_turn(double x, double y, std::index_sequence<k...>) {
  constexpr int count = sizeof...(k);
  using Which = decltype(Numbers<count>{} < Numbers<count>{});
  const Numbers<count> none = {};
  return Which{-static_cast<long long>(k % 2)...} ? y - none : x - none;
}
BLOCKS_INLINE Points everywhere(double x, double y) {
  return {in_turn(x, y, EachLane()), in_turn(x, y, EachLane())};
}
BLOCKS_INLINE Points operator+(const Points& a, const Points& b) {
  return {a.part[0] + b.part[0], a.part[1] + b.part[1]};
}
BLOCKS_INLINE Points operator-(const Points& a, const Points& b) {
  return {a.part[0] - b.part[0], a.part[1] - b.part[1]};
}
BLOCKS_INLINE Points operator*(double x, const Points& a) {
  return {x * a.part[0], x * a.part[1]};
}
BLOCKS_INLINE Points operator/(const Points& a, const Points& b) {
  return {a.part[0] / b.part[0], a.part[1] / b.part[1]};
}
/// Returns x^2 + y^2 for each block.
BLOCKS_INLINE Pack squared_norm(const Points& a) {
  const Point squares = rows_of(a.part[0] * a.part[0], a.part[1] * a.part[1]);
  return squares[0] + squares[1];
}

BLOCKS_INLINE Pack absolute(Pack x) {
  return reinterpret_cast<Pack>(reinterpret_cast<Mask>(x) & 0x7fffffffffffffff);
}
BLOCKS_INLINE Pack root(Pack x) {
  for (int k = 0; k < width; ++k)
    x[k] = __builtin_sqrt(x[k]);
  return x;
}
BLOCKS_INLINE Pack larger(Pack a, Pack b) { return a > b ? a : b; }
BLOCKS_INLINE bool any(Mask yes) {
  typedef signed char Marks __attribute__((vector_size(width)));
  const Marks marks = __builtin_convertvector(yes, Marks);
  unsigned long long word = 0;
  __builtin_memcpy(&word, &marks, width);
  return word != 0;
}

/// One integer for each block.
typedef int Ints __attribute__((vector_size(width * sizeof(int))));
/// Loads one integer for each block. Lanes without a block get 1.
template <class Lanes> BLOCKS_INLINE Ints load_ints(const void* column, Lanes lanes) {
  Ints x = Ints{} + 1;
  __builtin_memcpy(&x, column, lanes.count * sizeof(int));
  return x;
}
BLOCKS_INLINE bool any(Ints numbers) {
  typedef long long Words __attribute__((vector_size(sizeof(Ints))));
  const Words words = reinterpret_cast<Words>(numbers);
  long long all = 0;
  for (int k = 0; k < width / 2; ++k)
    all |= words[k];
  return all != 0;
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
