// `blocks import --map`: writes a deck that cuts blocks from the joints of a map.
#pragma once

#include <string>
#include <vector>

namespace blocks::convert {

struct MapImport {
  std::string file;                 ///< traces
  std::string output;               ///< empty: FILE's name with .deck, in this folder
  std::string outline;              ///< a file with the polygon to be cut; empty: none
  double snap = -1.0;               ///< [L] as on TRACES; < 0: not given
  std::vector<std::string> layers;  ///< "NAME=3", "NAME=outline", "NAME=skip"
  bool report_only = false;
  bool quiet = false;
};

/// Reads the map, gives each layer a joint id, cuts, and writes the deck. Returns a
/// code of run::ExitCode.
int import_map(MapImport options);

}  // namespace blocks::convert
