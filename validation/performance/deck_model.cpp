#include "deck_model.hpp"

#include <stdexcept>
#include <utility>

#include "run/run.hpp"

namespace blocks::bench {

std::string deck_path(const std::string& name) {
  return BLOCKS_SOURCE_DIR "/decks/" + name + "/" + name + ".deck";
}

Model deck_model(const std::string& name) {
  run::RunOptions options;
  options.deck = deck_path(name);
  options.quiet = true;
  run::CheckedDeck checked = run::build_checked(options);
  if (checked.code != run::done)
    throw std::runtime_error(options.deck + ": the deck has faults");
  return std::move(checked.model);
}

}  // namespace blocks::bench
