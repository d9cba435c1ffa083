// `blocks import`: converts outlines of other programs to a mesh for READ9.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace blocks::apps {

struct ImportOptions {
  std::string file;
  std::string output;           ///< empty: FILE's name with .mesh.txt, in this folder
  std::string format = "auto";  ///< auto, geojson, wkt, dxf, mesh
  int material = 0;             ///< of blocks for which the file gives none
  bool deck = false;            ///< also write a deck that uses the mesh
  bool map = false;             ///< lines are joints, from which a deck cuts blocks
  std::string outline;          ///< of a map: a file with its polygon; empty: none
  double snap = -1.0;           ///< of a map, [L] as on TRACES; < 0: not given
  std::vector<std::string> layers;  ///< of a map: "NAME=3", "NAME=outline", "NAME=skip"
  bool keep_overlaps = false;
  bool report_only = false;
  bool quiet = false;
};

void add_import_options(CLI::App& command, ImportOptions& options);

/// Reads the outlines, checks them and writes the mesh. Returns a code of
/// run::ExitCode.
int import_blocks(ImportOptions options);

}  // namespace blocks::apps
