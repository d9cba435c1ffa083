// All runs of a report: their parameters, how they ended, and their values. Reads the
// plans, the outcomes and the results, one run at a time; the memory does not grow with
// the size of the results.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/factor_of_safety.hpp"
#include "report/measure.hpp"
#include "report/members.hpp"
#include "report/profile_band.hpp"
#include "report/run_values.hpp"

namespace blocks::report {

/// What the user asks for.
struct Request {
  std::vector<std::string> folders;   ///< of the sweeps, at least one
  std::vector<std::string> measures;  ///< empty: a selection
  ReadingOptions reading;
  bool with_profile = true;                ///< if there are results
  std::optional<ProfileQuestion> profile;  ///< empty: the upper surface, dy
  bool pair = false;                       ///< compare two sweeps by seed
  bool mixed = false;  ///< the sweeps may have different decks, programs or numerics
};

/// How a run ended.
enum class State {
  done,
  unsound,     ///< exit code 4
  time_limit,  ///< 75: it used up its time limit, so it has not converged
  failed,      ///< any other error, or its own results cannot be found
  open         ///< no outcome yet: it is missing, at work or stopped
};

struct RunRow {
  std::size_t member = 0;  ///< index of the sweep
  std::size_t id = 0;      ///< of the run in its plan, from 1
  std::optional<std::uint64_t> seed;
  std::size_t group = 0;
  State state = State::open;
  std::optional<int> code;  ///< exit code; empty if open, or not known
  std::string status, message;
  std::optional<SafetyBracket> safety;  ///< empty: no FOS card
  /// Whether statistics of the sample count the run. Of a Sobol design these are the
  /// runs at the points a and b, which are independent of each other.
  bool in_sample = true;
  bool has_results = false;     ///< a results file of its own, which may be damaged
  std::vector<double> values;   ///< (measures) NaN: none
  std::vector<double> profile;  ///< (profile_positions), or empty
};

/// Runs that differ by their seeds only.
struct Group {
  std::vector<std::string> values;  ///< (parameters)
  std::vector<std::size_t> rows;    ///< in ascending order of seed, then of run
};

/// A measure with its name and unit in the report.
struct Column {
  Measure measure;
  std::string label;      ///< "smallest displacement y at the end"
  std::string unit;       ///< may be empty
  bool is_share = false;  ///< the values are 0 or 1
};

struct Ensemble {
  std::vector<Member> members;
  std::string title;                    ///< of the first deck
  std::optional<Units> units;           ///< of all values
  std::vector<std::string> parameters;  ///< names: "FRICTN.fric", "variant", "sweep"
  std::vector<Group> groups;            ///< in the order of the plans
  std::vector<std::string> sampled;     ///< names: the fields of Sobol designs
  std::vector<Column> columns;
  std::vector<RunRow> rows;  ///< in the order of the plans
  std::optional<ProfileQuestion> profile;
  std::vector<double> positions;  ///< (profile_positions) [L], or empty

  sweep::Kind kind() const { return members.front().plan.kind; }
  /// Returns the first measure that is not a share, or 0.
  std::size_t main_column() const;
  /// Returns whether the statistics count the run: it is done and in the sample.
  bool counts(const RunRow& row) const {
    return row.state == State::done && row.in_sample;
  }
  /// Returns the values of the sampled fields in a run; empty texts if it has none.
  std::vector<std::string> sampled_values(const RunRow& row) const;
  /// Returns the values of a column in a group, in the order of its rows; NaN for runs
  /// that do not count.
  std::vector<double> sample(std::size_t group, std::size_t column) const;
  /// Returns the results file of a run.
  std::string results_of(const RunRow& row) const;
  /// Returns the folder of a run.
  std::string folder_of(const RunRow& row) const;
  /// Returns "FRICTN.fric = 0.3, variant = default" of a group; empty if there are no
  /// parameters.
  std::string name_of(const Group& group) const;
};

/// Reads the sweeps. A run whose outcome is damaged, or whose results are missing or
/// those of another seed, has failed. Throws files::FileError if a plan cannot be
/// read. Throws std::runtime_error, with a hint, if the sweeps do not belong together,
/// a measure is unknown, or no finished run has it.
Ensemble read_ensemble(const Request& request);

}  // namespace blocks::report
