// `blocks export`: blocks of a deck or of results, for other programs.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "run/run.hpp"

namespace blocks::apps {

struct ExportOptions {
  run::RunOptions input;  ///< deck: the deck or the results
  std::string output;     ///< empty: the input's stem with .geojson, here
  std::string format;     ///< geojson, wkt, msh, txt, pvd, csv; empty: by the ending
  std::optional<double> time;  ///< the frame nearest to it; else the last
};

void add_export_options(CLI::App& command, ExportOptions& options);

/// Writes the blocks. Returns an exit code of run::ExitCode.
int export_blocks(ExportOptions options);

}  // namespace blocks::apps
