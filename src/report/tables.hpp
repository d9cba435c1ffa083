// The tables of a report: CSV and JSON for other programs, and text for the terminal.
// They depend on the runs only: not on the engine or the folder of the sweep, nor on
// the time that it took.
#pragma once

#include <string>

#include "report/analysis.hpp"
#include "report/ensemble.hpp"

namespace blocks::report {

/// Returns the statistics as CSV with one header line. The columns of the parameters
/// come first; a row is, by its column `kind`,
///
///     outcome     runs of a group that ended in the way `name`; mean is their share
///     quantity    the statistics of a measure in a group
///     difference  the paired differences of a measure from the reference group
///     first_order, total   the Sobol indices of a measure; n rows of the design count,
///                 `missing` do not, and `reference` has the parameter
///
/// Numbers are written so that they can be read back exactly; missing ones are empty.
std::string statistics_csv(const Ensemble& ensemble, const Analysis& analysis);

/// Returns the same numbers as JSON, and the bands of the profiles.
std::string statistics_json(const Ensemble& ensemble, const Analysis& analysis);

/// Returns a row for each run as CSV: parameters, seed, how it ended, and its values.
std::string runs_csv(const Ensemble& ensemble);

/// Returns a short table for the terminal.
std::string statistics_text(const Ensemble& ensemble, const Analysis& analysis);

/// Returns the message of a run without the paths of this computer.
std::string portable_message(const Ensemble& ensemble, const RunRow& row);

/// Returns what was swept in one line: "20 runs of subsidence.deck: seeds 1 to 20,
/// FRICTN.fric = .3, .5".
std::string sweep_words(const Ensemble& ensemble);

/// Returns "18 done, 2 unsound" of a group, or of all runs.
std::string outcome_words(const GroupStatistics& group);
std::string outcome_words(const Ensemble& ensemble);

}  // namespace blocks::report
