// Builds what cards say about their blocks and sides: numbers, ranges, selectors and
// outlines.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "deck/card_reader.hpp"

namespace blocks::deck {

/// Returns whether nb2 is not given beside a selector. Reports an error if it is.
bool has_no_range(const Value& nb1, const Value& nb2, const char* card,
                  Diagnostics& diagnostics);

/// Returns whether a block is given, or a selector of sides. Reports an error if not.
/// `f` begins with the block, whose field has the name `block`, and the side.
bool has_sides(const std::vector<Value>& f, std::string_view block, const char* card,
               Diagnostics& diagnostics);

/// Reads the blocks that REMOVE or FREE names; the parser adds the outline. Returns
/// nothing after a fault, which has been reported.
std::optional<Selection> build_selection(const std::vector<Value>& f, const char* card,
                                         Diagnostics& diagnostics);

}  // namespace blocks::deck
