// Reads the files that TRACES and VORONOI cards name, and reports their faults at these
// cards.
#pragma once

#include <optional>
#include <string>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "exchange/trace_reader.hpp"

namespace blocks::run {

/// A card that names a file.
struct FileOnCard {
  const char* card;  ///< "TRACES"
  const deck::Word& file;
  const std::string& folder;  ///< of the deck
};

/// Returns the traces, or nothing after an error. Faults have their place in the file.
std::optional<exchange::TraceFile> traces_of(const FileOnCard& named,
                                             deck::Diagnostics& diagnostics);
/// Returns the points likewise.
std::optional<exchange::PointFile> points_of(const FileOnCard& named,
                                             deck::Diagnostics& diagnostics);

}  // namespace blocks::run
