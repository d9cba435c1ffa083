// What the values of a checkpoint must be. All functions throw hdf5::Failure with the
// reason if a value is not as expected.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geometry/vec2.hpp"
#include "output/hdf5_handle.hpp"

namespace blocks::output::expectations {

using geometry::Vec2;

[[noreturn]] inline void reject_checkpoint(const std::string& what) {
  throw hdf5::Failure("no run writes such a state: " + what);
}

/// An interval of numbers, and how messages call it.
struct Range {
  double least, most;
  const char* words;
  bool open = false;  ///< `least` itself is excluded
};
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double largest = std::numeric_limits<double>::max();
inline constexpr Range finite{-largest, largest, "a finite number"};
inline constexpr Range not_negative{0.0, largest, "a number from 0"};
/// Counts that a double represents exactly.
inline constexpr Range count_from_0{0.0, 0x1p53, "a number from 0 to 9007199254740992"};
inline constexpr Range positive{0.0, largest, "a number above 0", true};
inline constexpr Range yes_or_no{0.0, 1.0, "0 or 1"};

inline bool holds(const Range& range, double value) {
  return value >= range.least && value <= range.most &&
         !(range.open && value == range.least);
}

inline void expect(const std::string& name, double value, const Range& range) {
  if (!holds(range, value))
    reject_checkpoint(fmt::format("{} is {}, expected {}", name, value, range.words));
}

inline void expect(const std::string& name, const Vec2& point) {
  expect(name, point.x(), finite);
  expect(name, point.y(), finite);
}

/// Expects `rows` rows with all values in the range.
template <class Column>
void expect_all(const char* name, const Column& column, Eigen::Index rows,
                const Range& range) {
  Eigen::Index width = 1, length = static_cast<Eigen::Index>(column.size());
  if constexpr (requires { column.cols(); })
    if (Column::ColsAtCompileTime != 1)
      width = column.rows(), length = column.cols();
  if (length != rows)
    reject_checkpoint(fmt::format("{} has {} rows, expected {}", name, length, rows));
  for (Eigen::Index i = 0; i < rows * width; ++i)
    if (const auto value = static_cast<double>(column.data()[i]); !holds(range, value))
      reject_checkpoint(fmt::format("{}: value {} is {}, expected {}", name,
                                    i / width + 1, value, range.words));
}

/// Expects an index in [0, n).
inline void expect_index(const std::string& name, long index, long n) {
  if (index < 0 || index >= n)
    reject_checkpoint(fmt::format("{} names number {} of {}", name, index + 1, n));
}

inline void expect_indices(const char* name, const std::vector<int>& column,
                           std::size_t rows, long n) {
  if (column.size() != rows)
    reject_checkpoint(
        fmt::format("{} has {} rows, expected {}", name, column.size(), rows));
  for (const int index : column)
    expect_index(name, index, n);
}

}  // namespace blocks::output::expectations
