// Descriptions of cards and fields that all forms of the reference share: screen,
// Markdown and man page.
#pragma once

#include <string>
#include <string_view>

#include "deck/cards/card_table.hpp"

namespace blocks::deck {

/// Returns the title of a group of cards in the reference.
std::string_view group_title(CardGroup group);
/// Returns "whole", "real", "decimal" or "word".
std::string_view kind_name(Kind kind);
/// Returns the default of a field, "blank" or "required".
std::string default_text(const FieldSpec& field);
/// Returns the allowed values of a field, or "any" if there is no limit.
std::string range_text(const FieldSpec& field);
/// Says how often the card may occur, and where the report describes it.
std::string occurrence_text(const CardSpec& card);
/// Returns the text with an initial capital and a final full stop.
std::string sentence(std::string_view text);

}  // namespace blocks::deck
