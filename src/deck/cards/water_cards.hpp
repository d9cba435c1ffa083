// The part of the card table that puts water into joints: WATER, JWATER
// (docs/water.md).
#pragma once

#include <optional>
#include <vector>

#include "deck/card_reader.hpp"
#include "deck/cards/card_table.hpp"

namespace blocks::deck {

/// Returns these cards. Use card_table() to read them.
std::vector<CardSpec> water_cards();

/// Builds WATER; a table needs the weight of the water. The points follow on lines.
std::optional<Card> build_water(const std::vector<Value>& fields,
                                Diagnostics& diagnostics);

/// Builds JWATER; a pressure needs two different points.
std::optional<Card> build_joint_water(const std::vector<Value>& fields,
                                      Diagnostics& diagnostics);

}  // namespace blocks::deck
