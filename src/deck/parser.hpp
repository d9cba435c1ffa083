// Deck text -> commands, driven by the card table. Reports every fault through the
// diagnostics and goes on, so that one pass shows them all.
#pragma once

#include <string>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"

namespace blocks::deck {

/// Overrides from the command line: --set CARD.field=value. Unknown names are errors.
struct Override {
  std::string card, field, value;
};

/// Parses the text held by the diagnostics. With errors, the deck holds what could be
/// read.
Deck parse(const std::string& file, const std::string& text, Diagnostics& diagnostics,
           const std::vector<Override>& overrides = {});

/// Problem cards for a model that exists already; no cards at all are none.
Deck parse_further(const std::string& file, const std::string& text,
                   Diagnostics& diagnostics);

}  // namespace blocks::deck
