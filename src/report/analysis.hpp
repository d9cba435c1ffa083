// The statistics of the groups of a report.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/ensemble.hpp"
#include "report/factor_of_safety.hpp"
#include "report/profile_band.hpp"
#include "report/sensitivity.hpp"
#include "report/statistics.hpp"

namespace blocks::report {

/// How many runs ended in one way, and their share of the runs that ended.
struct OutcomeCount {
  State state = State::done;
  std::size_t count = 0;
  Interval share;  ///< Wilson; NaN for open runs
};

/// One measure in one group.
struct ColumnStatistics {
  Summary summary;          ///< of the runs that are done
  std::size_t missing = 0;  ///< runs that are done, but have no value
  /// For a share, its Wilson interval; otherwise the t interval of the mean.
  Interval interval;
  std::optional<std::size_t> needed;     ///< runs for the precision; empty for a share
  std::size_t min_row = 0, max_row = 0;  ///< of the ensemble, if n > 0
};

/// The paired difference of a group from its reference: the group with the same other
/// parameters, and the first value of the compared one.
struct GroupDifferences {
  std::size_t reference = 0;     ///< index of the group
  std::vector<Summary> columns;  ///< (columns)
};

struct GroupStatistics {
  std::vector<OutcomeCount> outcomes;     ///< in the order of State
  std::size_t ended = 0;                  ///< runs with an outcome
  std::vector<ColumnStatistics> columns;  ///< (columns)
  std::optional<ProfileBand> profile;
  std::optional<GroupDifferences> differences;
  FailureCount failure;  ///< of the runs that are done and have a factor of safety
};

struct Analysis {
  Precision precision;
  std::vector<GroupStatistics> groups;  ///< (groups)
  /// The index of the parameter whose values are compared by seed, if any.
  std::optional<std::size_t> compared;
  /// The numbers of the compared parameter, (groups), if it has numbers only.
  std::vector<double> axis;
  std::vector<Sensitivity> sensitivities;  ///< of the sweeps with a Sobol design
};

Analysis analyse(const Ensemble& ensemble, const Precision& precision);

/// Returns the row of the run of a group that is nearest to the median of a column.
/// Empty if no run is done. The earlier one of two that are equally near.
std::optional<std::size_t> median_run(const Ensemble& ensemble,
                                      const Analysis& analysis, std::size_t group,
                                      std::size_t column);

/// Returns "done", "unsound", "time limit", "failed" or "not finished".
const char* name_of(State state);

}  // namespace blocks::report
