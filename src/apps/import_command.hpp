// `blocks import`: outlines of other programs become a mesh for READ9.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace blocks::apps {

struct ImportOptions {
  std::string file;
  std::string output;           ///< empty: FILE's stem with .mesh.txt, here
  std::string format = "auto";  ///< auto, geojson, wkt, mesh
  int material = 0;             ///< of blocks whose material the file does not say
  bool deck = false;            ///< a deck skeleton beside the mesh
  bool keep_overlaps = false;
  bool report_only = false;
  bool quiet = false;
};

void add_import_options(CLI::App& command, ImportOptions& options);

/// Reads, checks, writes. Returns an exit code of run::ExitCode.
int import_blocks(ImportOptions options);

}  // namespace blocks::apps
