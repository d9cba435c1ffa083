// Reads the files that OUTLINE, TRACES and VORONOI cards name, and reports their faults
// at these cards.
#pragma once

#include <map>
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

/// Reads the files of TRACES cards. A file that several cards name for its layers is
/// read once.
class TraceFiles {
 public:
  explicit TraceFiles(const std::string& folder) : folder_(folder) {}

  /// Returns the traces of the card's layer, with the id of the card, or those of all
  /// layers with their own ids; nothing after an error. Faults have their place in the
  /// file.
  std::optional<exchange::TraceFile> of(const deck::Traces& card,
                                        deck::Diagnostics& diagnostics);

 private:
  const std::string& folder_;  ///< of the deck
  std::map<std::string, std::optional<exchange::TraceFile>> with_layers_;
};
/// Returns the points likewise.
std::optional<exchange::PointFile> points_of(const FileOnCard& named,
                                             deck::Diagnostics& diagnostics);

/// Reads the corners of outlines from their files into the CUT commands. The corners
/// are clockwise. A command without a sound outline is moved to the unread cards.
void read_outline_files(deck::Deck& deck, const std::string& folder,
                        deck::Diagnostics& diagnostics);

}  // namespace blocks::run
