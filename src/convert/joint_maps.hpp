// Reads maps of traces for `blocks joints`: trace files with their windows, and the
// joints of decks before they are cut.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "deck/parser.hpp"
#include "joints/trace_map.hpp"

namespace blocks::convert {

struct MapInput {
  std::vector<std::string> files;     ///< trace files and decks; - is standard input
  std::vector<std::string> outlines;  ///< windows of the trace files, in their order;
                                      ///< the last one is that of all further files
  double snap = 0.0;                  ///< [L] >= 0
  std::optional<std::uint64_t> seed;  ///< of decks
  std::vector<deck::Override> overrides;
};

/// The maps, or an exit code after errors, which have been printed.
struct ReadMaps {
  int code = 0;
  std::vector<joints::TraceMap> maps;
};

/// Reads the maps in the order of the files. A deck gives one map for each group
/// OUTLINE ... CUT. Loose ends of trace files within `snap` are joined; those of decks
/// are joined as their TRACES cards say. Prints errors and warnings. Throws
/// files::FileError if a file cannot be read.
ReadMaps read_maps(const MapInput& input);

}  // namespace blocks::convert
