// `blocks history`: the command line of histories and profiles.
#pragma once

#include <CLI/App.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "apps/options/common_options.hpp"

namespace blocks::apps {

struct HistoryOptions {
  std::vector<std::string> files;
  std::vector<std::string> quantities;  ///< empty: an overview
  std::string against;                  ///< empty: time
  std::string profile;                  ///< empty: histories
  std::vector<double> times;            ///< of a profile; empty: the last frame
  std::optional<double> mirror;         ///< of a profile: x of the plane [L]
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  std::vector<std::string> outputs;  ///< files; empty: print a table
  bool csv = false, json = false;    ///< print in this format
  std::optional<std::string> title;  ///< of a figure; empty: those of the runs
  bool frames = false;               ///< not the samples of HISTORY
  bool compression_positive = false;
  bool each_run = false;  ///< no bands
  bool paths = false;     ///< write the paths of the results in a figure
  std::string units;      ///< "m,kg,s"
  FigureSize size;        ///< of a figure
};

void add_history_options(CLI::App& command, HistoryOptions& options);

/// Prints or writes histories or profiles. Returns a code of run::ExitCode.
int history(HistoryOptions options);

}  // namespace blocks::apps
