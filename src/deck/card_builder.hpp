// Builds the struct of a card from its fields, and checks conditions that involve two
// fields.
#pragma once

#include <optional>
#include <string_view>

#include "deck/card_reader.hpp"

namespace blocks::deck {

/// Returns the struct of a card whose values are all valid, or nothing after a fault,
/// which has then been reported. The parser handles CLOOP, and the lists and titles on
/// further lines.
std::optional<Card> build_card(std::string_view name, const Values& values,
                               Diagnostics& diagnostics);

}  // namespace blocks::deck
