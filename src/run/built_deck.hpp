// Builds the model of a deck without making steps, which finds all faults of the deck.
// A run goes on with what is built here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "run/builder/builder_state.hpp"
#include "run/job.hpp"

namespace blocks::run {

inline constexpr const char* nothing_written =
    "blocks: interrupted; no file was written\n";

/// The model at a card before which no block moves.
struct Stage {
  std::size_t card;  ///< its index; the number of commands: at the end of the deck
  Model model;
  std::vector<std::string> notes;  ///< on what cards did since the stage before
  bool changed;                    ///< cards have acted since the stage before
};

struct BuiltDeck {
  /// In the order of their cards, at least one. The last one is at the first MOTION,
  /// CYCLE, SOLVE or FOS, or at the end if there is none. The others are at DUMP and
  /// SAVE cards, which write the state of that moment. A card that finds the model as
  /// the stage before has it needs no stage. A deck that resumes begins with one.
  std::vector<Stage> stages;
  /// The cards up to this index, it included, have acted on the last stage.
  std::size_t built_to;
  BuilderState builder;            ///< after these cards
  std::vector<std::string> notes;  ///< on what all cards of the deck did, one per line

  /// The model when blocks begin to move, or at the end.
  Model& start() { return stages.back().model; }
};

/// Whether the card may change the model by itself, without steps.
bool changes_model(const deck::Command& command);

/// Executes all cards of the deck without making steps. Messages about them are added
/// to the diagnostics of the job. Returns nothing after errors, and after an interrupt,
/// which it tells; Job::fault is then the exit code. Throws files::FileError if the
/// checkpoint of --restart cannot be continued.
std::optional<BuiltDeck> build(Job& job);

}  // namespace blocks::run
