// A measure is a number that the report takes from each run of a sweep, such as the
// smallest displacement at the end. The user names it.
#pragma once

#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "quantities/curve.hpp"

namespace blocks::report {

/// A number of one run.
///
///     CURVE         a quantity of `blocks history`, at the end of the run
///     CURVE@0.5     at this time, linear between two samples or frames
///     CURVE@max     its largest value over time, CURVE@min the smallest
///     profile:min   the smallest value of the profile, profile:max the largest
///     NAME          a number in outcome.json, such as p21 or aspect:max
///     fos           the middle of the proved ends of the factor of safety; also
///                   fos_lower and fos_upper, these ends
///
/// With <LIMIT or >LIMIT after it, it is 1 if the number is below or above the limit,
/// otherwise 0, and the report gives the share of the runs. fos<LIMIT is decided by the
/// proved ends, and a run has no value if they do not decide it.
struct Measure {
  enum class From { curve, profile, outcome };
  enum class When { end, time, largest, smallest };
  struct Limit {
    bool above = false;
    double value = 0.0;  ///< in the units of the report
  };

  std::string name;  ///< as the user writes it, in one form
  From from = From::curve;
  quantities::Curve curve;
  When when = When::end;
  double time = 0.0;  ///< [T]
  std::string key;    ///< of outcome.json, or "min" or "max" of a profile
  std::optional<Limit> limit;

  /// Returns the number, or 1 or 0 if there is a limit; NaN remains NaN.
  double with_limit(double value) const;
};

/// Reads a measure. `outcome_names` are the measures of the outcomes. If a name is also
/// that of a curve, `outcomes_first` decides; "outcome.NAME" always means the outcome.
/// Throws std::runtime_error with a hint.
Measure parse_measure(const std::string& text,
                      const std::set<std::string>& outcome_names, bool outcomes_first);

}  // namespace blocks::report
