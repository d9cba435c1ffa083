// `blocks cracks`: the command line of the record of cracks.
#pragma once

#include <CLI/App.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "apps/options/common_options.hpp"

namespace blocks::apps {

struct CracksOptions {
  std::string file;
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  std::vector<std::string> outputs;  ///< files; empty: print a table
  bool csv = false, json = false;    ///< print in this format
  std::optional<std::string> title;  ///< of a figure; empty: that of the run
  std::string units;                 ///< "m,kg,s"
  FigureSize size;                   ///< of a figure
};

void add_cracks_options(CLI::App& command, CracksOptions& options);

/// Prints or writes the cracks of a run. Returns a code of run::ExitCode.
int cracks(const CracksOptions& options);

}  // namespace blocks::apps
