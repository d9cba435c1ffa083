// Reads the files that OUTLINE, TRACES and VORONOI cards name, and reports their faults
// at these cards.
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

/// Returns the traces of the card's layer, or of all layers, or nothing after an error.
/// Faults have their place in the file. folder: of the deck.
std::optional<exchange::TraceFile> traces_of(const deck::Traces& card,
                                             const std::string& folder,
                                             deck::Diagnostics& diagnostics);
/// Returns the points likewise.
std::optional<exchange::PointFile> points_of(const FileOnCard& named,
                                             deck::Diagnostics& diagnostics);

/// Reads the corners of outlines from their files into the CUT commands. The corners
/// are clockwise. A command without a sound outline is moved to the unread cards.
void read_outline_files(deck::Deck& deck, const std::string& folder,
                        deck::Diagnostics& diagnostics);

}  // namespace blocks::run
