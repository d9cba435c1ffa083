// `blocks cards`: describes the cards, or lists what --set can change in a deck.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace blocks::apps {

struct CardsOptions {
  std::string card;       ///< card to describe; empty: list all
  std::string deck;       ///< deck of --set; empty: none
  bool markdown = false;  ///< the whole reference
};

void add_cards_options(CLI::App& command, CardsOptions& options);

/// Returns an exit code of run/run.hpp. Throws files::FileError if the deck cannot be
/// read.
int cards(const CardsOptions& options);

}  // namespace blocks::apps
