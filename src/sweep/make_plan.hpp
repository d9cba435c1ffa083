// Makes the plan of a sweep from the words of the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweep/plan.hpp"

namespace blocks::sweep {

/// What is to be swept.
struct Request {
  std::string deck;   ///< path of the deck; of a study: scenes, "a,b" or "all"
  std::string seeds;  ///< "1-200,250"; empty: the seed of the deck
  std::vector<std::string> sets;  ///< "CARD.field=value,value"
  /// "CARD.field=low..high,...": a design for Sobol indices; may be empty
  std::string sobol;
  std::size_t rows = 0;         ///< of that design; 0: not given
  std::string table;            ///< path of a CSV of parameters; may be empty
  std::optional<double> until;  ///< [T]
  long audit_every = 0;         ///< steps; 0: no audit
  Kind kind = Kind::run;
  std::vector<std::string> variants;  ///< of a study; empty: all
};

/// Returns the plan of a study: one run for each scene and frame, whose number is the
/// seed. Its files are named "study". Throws AxisFault if a scene or a variant is
/// unknown.
Plan make_study_plan(const Request& request);

/// Returns the plan for a deck. Parses the deck with every value that a run sets, and
/// checks the first run as `blocks check` does. Errors of the deck are printed; `code`
/// is then the exit code, and otherwise run::done. Throws AxisFault, or
/// files::FileError if a file cannot be read.
Plan make_plan(const Request& request, int& code);

}  // namespace blocks::sweep
