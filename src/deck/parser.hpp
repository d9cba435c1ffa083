// Parses deck text into commands according to the card table. It reports every fault
// through the diagnostics and continues, so that one pass shows them all.
#pragma once

#include <optional>
#include <string>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"

namespace blocks::deck {

/// An override from the command line: --set CARD.field=value. Unknown names are errors.
struct Override {
  std::string card, field, value;
};

/// Splits "CARD.field=value" or "CARD[2].field=value". Returns nothing if it has another
/// form.
std::optional<Override> parse_override(const std::string& text);

/// Parses the text held by the diagnostics. If there are errors, the deck contains what
/// could be read.
Deck parse(const std::string& file, const std::string& text, Diagnostics& diagnostics,
           const std::vector<Override>& overrides = {});

/// Parses problem cards for a model that already exists; the text may be empty.
Deck parse_further(const std::string& file, const std::string& text,
                   Diagnostics& diagnostics);

}  // namespace blocks::deck
