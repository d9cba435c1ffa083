// The parameters of a sweep, and the runs that they make.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace blocks::sweep {

/// The largest number of runs of one sweep.
constexpr std::size_t max_runs = 1'000'000;
constexpr std::uint64_t largest_seed = 9007199254740991ULL;  // 2^53 - 1

/// A parameter that is not written as it must be; `hint` says what to do next.
struct AxisFault : std::runtime_error {
  AxisFault(const std::string& what, std::string what_next)
      : std::runtime_error(what), hint(std::move(what_next)) {}
  std::string hint;
};

/// The seed and the values in which one run differs from others.
struct Variation {
  std::optional<std::uint64_t> seed;  ///< empty: that of the deck
  std::vector<std::string> sets;      ///< "CARD.field=value", in the order of the axes

  bool operator==(const Variation&) const = default;
};

/// The values of one field: --set FRICTN.fric=.3,.5.
struct Axis {
  std::string field;                ///< "FRICTN.fric", "MATERIAL[2].rho"
  std::vector<std::string> values;  ///< as written, at least one, all different
};

/// Returns the text without spaces at its ends.
std::string trimmed(const std::string& text);

/// Whether a name has the form CARD.field.
bool is_field(const std::string& name);

/// Reads seeds: "1-200,250". Throws AxisFault unless they are whole numbers from 0 to
/// 2^53 - 1, all different, at most max_runs of them.
std::vector<std::uint64_t> parse_seeds(const std::string& text);

/// Reads "CARD.field=value,value". Throws AxisFault.
Axis parse_axis(const std::string& text);

/// Reads a table of parameters as CSV (RFC 4180). The first line names the columns:
/// "seed" or CARD.field. Each further line is a run. Throws AxisFault with the line.
std::vector<Variation> parse_table(const std::string& text);

/// Returns all combinations, in this order: by row of the table, by value of the first
/// axis, of the second ..., by seed. No rows, axes or seeds mean one run of the deck as
/// it is. Throws AxisFault if a parameter is given twice, two runs are the same, or
/// there are more than max_runs of them.
std::vector<Variation> combine(const std::vector<Variation>& rows,
                               const std::vector<Axis>& axes,
                               const std::vector<std::uint64_t>& seeds);

/// Returns the name of the field of "CARD.field=value".
std::string field_of(const std::string& set);

/// Returns what a run sets: "seed" if it has one, and its fields, in order.
std::vector<std::string> axes_of(const Variation& run);

/// Returns the value of "CARD.field=value".
std::string value_of(const std::string& set);

/// Returns the values of a run in one line: "seed 7, FRICTN.fric=.3". Empty if it has
/// none.
std::string words_of(const Variation& run);

}  // namespace blocks::sweep
