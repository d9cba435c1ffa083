// What a report must know of its sweeps before it reads the runs one by one.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "post/read/units.hpp"
#include "report/members.hpp"

namespace blocks::report {

struct Preview {
  std::string title;                            ///< of the first deck
  std::optional<Units> units;                   ///< of the report
  std::vector<std::optional<Units>> own_units;  ///< (sweeps) of their decks
  /// Names of the measures in an outcome, and those of them that are 0 or 1.
  std::set<std::string> outcome_names, outcome_shares;
  /// A results file that can be read, of a run that is done if there is one; or empty.
  std::string first_results;
};

/// Finds these by the first runs that have them. `requested`: the units that the user
/// names, otherwise those of the first deck. Throws std::runtime_error, with a hint, if
/// only some of the decks name their units.
Preview look_ahead(const std::vector<Member>& members,
                   const std::optional<Units>& requested);

}  // namespace blocks::report
