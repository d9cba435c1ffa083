// `blocks export`: writes blocks of a deck or of results for other programs.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "run/run.hpp"

namespace blocks::apps {

struct ExportOptions {
  run::RunOptions input;  ///< input.deck is the deck or the results
  std::string output;     ///< empty: the input's name with .geojson, in this folder
  std::string format;     ///< geojson, wkt, dxf, svg, ...; empty: from the extension
  double scale = 0.0;     ///< of SVG, 1:scale; 0: the largest usual one that fits on A4
  std::optional<double> time;  ///< the nearest frame is used; empty: the last one
};

void add_export_options(CLI::App& command, ExportOptions& options);

/// Writes the blocks. Returns a code of run::ExitCode.
int export_blocks(ExportOptions options);

}  // namespace blocks::apps
