// The fields of one card -> its struct, with the checks that need two fields at once.
#pragma once

#include <optional>
#include <string_view>

#include "deck/card_reader.hpp"

namespace blocks::deck {

/// The struct of a card whose values are all right; nothing after a fault, which has
/// then been reported. CLOOP, and the lists and titles on further lines, are the
/// parser's.
std::optional<Card> build_card(std::string_view name, const Values& values,
                               Diagnostics& diagnostics);

}  // namespace blocks::deck
