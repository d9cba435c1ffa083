// The factor of safety F of the runs of a sweep, between its proved ends, and the share
// of the runs in which it is below 1. Independent of files.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "report/measure.hpp"
#include "report/statistics.hpp"
#include "sweep/outcome.hpp"

namespace blocks::report {

/// The names of the measures of F: "fos", "fos_lower", "fos_upper".
const std::set<std::string>& safety_names();

/// F of one run is at least `lower` and at most `upper`. An end is NaN if no trial
/// proved it.
struct SafetyBracket {
  double lower = no_number, upper = no_number;

  /// Returns the middle of both ends; NaN if one of them is not proved.
  double middle() const;
  /// Returns 1 if F is proved to be below the limit (upper <= limit), 0 if it is proved
  /// not to be (lower >= limit), otherwise NaN. A limit that F is to be above has the
  /// opposite answers.
  double decide(const Measure::Limit& limit) const;
};

/// Returns what the outcome of a run has; empty if its deck has no FOS card.
std::optional<SafetyBracket> safety_bracket(const sweep::Outcome& outcome);

/// Returns the value of a measure that is one of safety_names().
double safety_value(const SafetyBracket& bracket, const Measure& measure);

/// How many runs of a group have F < 1. The runs are those that are done and have a
/// bracket. Groups are not added: a share over the values of a parameter has no meaning.
struct FailureCount {
  std::size_t failing = 0;    ///< upper <= 1
  std::size_t stable = 0;     ///< lower >= 1
  std::size_t undecided = 0;  ///< the bracket has 1 inside, or an end is not proved

  void add(const SafetyBracket& bracket);
  std::size_t total() const { return decided() + undecided; }
  std::size_t decided() const { return failing + stable; }
  /// Returns failing / decided; NaN if no run is decided.
  double share() const;
  /// Returns Wilson's interval of that share.
  Interval interval() const { return wilson(failing, decided()); }
};

/// Returns "F < 1 in 12 of 190 runs: 6.3 % (95 % interval 3.6 to 10.7 %); 8 more are
/// undecided".
std::string failure_words(const FailureCount& count);

}  // namespace blocks::report
