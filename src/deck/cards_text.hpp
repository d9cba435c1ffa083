// The deck reference as text, from the card table: `blocks cards [NAME]` and
// docs/cards.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/suggest.hpp"

namespace blocks::deck {

/// One line per card, grouped by phase.
std::string all_cards();

/// The page of a card (name in any case): syntax, meaning, table of fields with default
/// and range, lines that follow, example. Nothing for an unknown card.
std::optional<std::string> card_page(std::string_view name);

/// The card nearest to an unknown name, or empty.
std::string suggest_card(std::string_view name);

/// How decks are written, in paragraphs.
std::vector<std::string_view> reference_introduction();

/// A deck made of the examples of all cards but RESTART.
std::string all_examples();

/// All pages in Markdown.
std::string card_reference_markdown();

}  // namespace blocks::deck
