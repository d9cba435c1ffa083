// The words for cards and fields that every form of the reference shares: on the
// screen, in Markdown, as a man page.
#pragma once

#include <string>
#include <string_view>

#include "deck/card_table.hpp"

namespace blocks::deck {

std::string_view phase_title(Phase phase);
/// whole, real, decimal, word
std::string_view kind_name(Kind kind);
/// The default of a field, "blank" or "required".
std::string default_text(const FieldSpec& field);
/// What a field may be; "any" without limits.
std::string range_text(const FieldSpec& field);
/// How often the card may stand, and where in the report.
std::string standing(const CardSpec& card);
/// With a capital at the beginning and a full stop at the end.
std::string sentence(std::string_view text);

}  // namespace blocks::deck
