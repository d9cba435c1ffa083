// `blocks check`: command line of the check and of its report on the geometry.
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

/// Checks the deck, and its geometry if asked. Returns an exit code of run::ExitCode:
/// deck_error when blocks overlap beyond rounding.
int check(const run::RunOptions& options, const GeometryOptions& geometry);

}  // namespace blocks::apps
