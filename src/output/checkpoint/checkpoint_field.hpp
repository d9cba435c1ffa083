// A field of a checkpoint: its name, and what its values must be in every state of a
// run.
#pragma once

#include <limits>
#include <type_traits>

namespace blocks::output {

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// An interval of numbers, and how messages call it.
struct Range {
  double min = 0.0, max = 0.0;
  const char* words = nullptr;  ///< null: no range
  bool open = false;            ///< `min` itself is excluded

  /// Returns whether the value is in the interval; false if it is not a number.
  constexpr bool holds(double value) const {
    return value >= min && value <= max && !(open && value == min);
  }
};
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double largest = std::numeric_limits<double>::max();
inline constexpr Range finite{-largest, largest, "a finite number"};
inline constexpr Range not_negative{0.0, largest, "a number from 0"};
/// Counts that a double represents exactly.
inline constexpr Range count_from_0{0.0, 0x1p53, "a number from 0 to 9007199254740992"};
inline constexpr Range positive{0.0, largest, "a number above 0", true};
inline constexpr Range up_to_1{0.0, 1.0, "a number from 0 to 1"};
inline constexpr Range yes_or_no{0.0, 1.0, "0 or 1"};

/// What an index refers to. It is at least 0, and less than the number of these.
enum class IndexOf {
  nothing,  ///< the field is no index
  block,
  block_or_none,  ///< may be -1
  corner,
  plane,
  safety_factor,
};

/// The number of rows of a column.
enum class Rows {
  any,
  per_block,
  per_block_or_none,  ///< one for each block, or no row
  per_corner,
};

/// The name of a field, of a member of all records in a list, or of such a list, and
/// what its values must be. A field without a range has that of its list, or is finite.
struct Field {
  const char* name;
  Range range = {};
  IndexOf index = IndexOf::nothing;
  Rows rows = Rows::any;

  constexpr Field(const char* its_name) : name(its_name) {}
  constexpr Field(const char* its_name, const Range& its_range, Rows its_rows = {})
      : name(its_name), range(its_range), rows(its_rows) {}
  constexpr Field(const char* its_name, IndexOf kind) : name(its_name), index(kind) {}
  constexpr Field(const char* its_name, Rows its_rows)
      : name(its_name), rows(its_rows) {}
};

}  // namespace blocks::output
