// `blocks report`: the command line of the statistics of a sweep.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

namespace blocks::apps {

struct ReportOptions {
  std::vector<std::string> folders;
  std::vector<std::string> quantities;  ///< empty: a selection
  std::vector<std::string> outputs;     ///< files; empty: report.html in the folder
  std::string runs;                     ///< CSV with a row for each run; may be empty
  std::string profile;                  ///< empty: top if there are results
  std::string profile_quantity = "dy";
  std::optional<double> time;    ///< of the profile; empty: the last frame
  std::optional<double> mirror;  ///< of the profile: x of the plane [L]
  std::string precision = "5%";
  std::string units;  ///< "m,kg,s"
  std::string size;   ///< of figures, "85mm"; empty: 175mm
  std::optional<std::string> title;
  bool compression_positive = false;
  bool frames = false;  ///< not the samples of HISTORY
  bool pair = false, mixed = false;
  int pages = 100;  ///< the most runs that get a page to play
  bool quiet = false;
};

void add_report_options(CLI::App& command, ReportOptions& options);

/// Writes the report. Returns a code of run::ExitCode.
int report(ReportOptions options);

}  // namespace blocks::apps
