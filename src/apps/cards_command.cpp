#include "cards_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "deck/cards/cards_text.hpp"
#include "deck/cards/settable.hpp"
#include "deck/parser.hpp"
#include "run/run.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::apps {
namespace {

int list_settable(const std::string& path) {
  const std::string text = run::read_deck(path);
  deck::Diagnostics diagnostics(path == "-" ? "<standard input>" : path, text);
  deck::parse(path, text, diagnostics);
  if (diagnostics.has_errors()) {
    std::cerr << diagnostics.format_all();
    return run::deck_error;
  }
  for (const std::string& line : deck::settable_fields(text))
    std::cout << line << '\n';
  return run::done;
}

}  // namespace

void add_cards_options(CLI::App& command, CardsOptions& options) {
  auto* name = command.add_option("NAME", options.card,
                                  "card to describe (default: list all cards)");
  auto* markdown = command.add_flag("--markdown", options.markdown,
                                    "print the whole reference as Markdown");
  command
      .add_option("--set", options.deck,
                  "list the fields of this deck that --set of run and check can "
                  "replace, with their values, as CARD.field=value")
      ->type_name("DECK")
      ->excludes(name)
      ->excludes(markdown);
}

int cards(const CardsOptions& options) {
  if (!options.deck.empty())
    return list_settable(options.deck);
  if (options.markdown) {
    std::cout << deck::card_reference_markdown();
    return run::done;
  }
  if (options.card.empty()) {
    std::cout << deck::all_cards();
    return run::done;
  }
  if (const auto page = deck::card_page(options.card)) {
    std::cout << *page;
    return run::done;
  }
  const std::string near = deck::suggest_card(options.card);
  fmt::print(stderr, "blocks: error: there is no card {}\n  hint: {}\n", options.card,
             near.empty() ? "'blocks cards' lists all cards"
                          : fmt::format("did you mean {}?", near));
  return run::usage_error;
}

}  // namespace blocks::apps
