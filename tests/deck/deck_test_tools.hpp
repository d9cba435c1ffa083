// Decks given as text, for the tests of this folder.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "deck/parser.hpp"

namespace blocks::deck {

/// A parsed deck and its messages.
struct Parsed {
  Deck deck;
  std::string messages;

  /// Returns the last card of that type. Throws if there is none.
  template <class T> const T& only() const {
    const T* found = nullptr;
    for (const Command& command : deck.commands) {
      if (const T* card = std::get_if<T>(&command.card)) {
        found = card;
      }
    }
    if (found == nullptr) {
      throw std::runtime_error("card not found\n" + messages);
    }
    return *found;
  }
};

inline Parsed parse_text(const std::string& text,
                         const std::vector<Override>& overrides = {}) {
  Diagnostics diagnostics("t.deck", text);
  Deck deck = parse("t.deck", text, diagnostics, overrides);
  return {std::move(deck), diagnostics.format_all()};
}

/// Seven preliminary cards, including END.
inline const std::string preliminary_cards =
    "START, 100, 6\nTitle\nXLIMITS, 0, 9\n"
    "YLIMITS, 0, 9\nBOXES, 1, 1\nFRACTION, .1\n"
    "MATERIAL, 1, , , 2.\nEND\n";

}  // namespace blocks::deck
