// `blocks check`: the command line of the check and of the geometry report.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "run/run.hpp"

namespace blocks::apps {

struct GeometryOptions {
  bool report = false;  ///< --geometry
  bool json = false;
  std::string plot;  ///< file name; empty: no figure
};

void add_geometry_options(CLI::App& command, GeometryOptions& options);

/// Checks the deck, and reports on its geometry if --geometry or --plot is given.
/// Returns a code of run::ExitCode; it is deck_error if blocks overlap by more than
/// rounding.
int check(const run::RunOptions& options, const GeometryOptions& geometry);

}  // namespace blocks::apps
