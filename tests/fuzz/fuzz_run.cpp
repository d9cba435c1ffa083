// Reads any bytes as a deck, builds the model and makes steps
// (reliability/deck_trial.hpp). Decks with more than 100 blocks are skipped, because
// they are slow.
#include <cstddef>
#include <cstdint>
#include <string>

#include "deck/parser.hpp"
#include "reliability/deck_trial.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  blocks::deck::Diagnostics told("fuzz", text);
  const auto deck = blocks::deck::parse("fuzz", text, told);
  if (told.has_errors())
    return 0;
  const auto* start = std::get_if<blocks::deck::Start>(&deck.commands.front().card);
  if (start != nullptr && start->nblok.value <= 100)
    blocks::testing::try_deck(text, BLOCKS_SOURCE_DIR "/decks/every_card", 2);
  return 0;
}
