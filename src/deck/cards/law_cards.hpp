// The part of the card table that gives joints strength, and moves fixed blocks: JOINT,
// WALTON, BARTON, JPAIR, BOND, DRIVE (docs/laws.md).
#pragma once

#include <optional>
#include <vector>

#include "deck/card_reader.hpp"
#include "deck/cards/card_table.hpp"

namespace blocks::deck {

/// Returns these cards. Use card_table() to read them.
std::vector<CardSpec> law_cards();

/// Builds JOINT from its fields: blank residual values are those of the peak, and a
/// blank ks is kn. Reports every value that contradicts another one, and returns
/// nothing after a fault. A tensile strength above the apex of the envelope is lowered
/// to it, with a warning.
std::optional<Card> build_joint(const std::vector<Value>& fields,
                                Diagnostics& diagnostics);

/// Builds BARTON; knmax must not be less than kni.
std::optional<Card> build_barton(const std::vector<Value>& fields,
                                 Diagnostics& diagnostics);

}  // namespace blocks::deck
