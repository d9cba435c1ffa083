// The deck reference as text, generated from the card table, for `blocks cards [NAME]`
// and docs/cards.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blocks::deck {

/// Returns one line per card, by group.
std::string all_cards();

/// Returns the page of a card, whose name may be in any case. It contains syntax,
/// meaning, a table of fields with defaults and ranges, the lines that follow, and an
/// example. Returns nothing for an unknown card.
std::optional<std::string> card_page(std::string_view name);

/// Returns the card nearest to an unknown name, or an empty string.
std::string suggest_card(std::string_view name);

/// Returns paragraphs that explain how decks are written.
std::vector<std::string_view> reference_introduction();

/// Returns a deck that consists of the examples of all cards except RESTART.
std::string all_examples();

/// Returns all pages in Markdown.
std::string card_reference_markdown();

}  // namespace blocks::deck
