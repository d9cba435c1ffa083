// A deck that is to be run or checked, and the checkpoint that it continues from.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "output/checkpoint/checkpoint.hpp"
#include "run/builder/builder_state.hpp"
#include "run/support/run_options.hpp"

namespace blocks::run {

/// A deck with everything needed to build its model and to run it.
struct Job {
  /// Reads and parses the deck. With --until, adds a MOTION card behind the last card
  /// that acts. Throws files::FileError if the deck cannot be read.
  explicit Job(const RunOptions& given);

  BuildOptions build_options() const;
  /// Whether the deck begins with RESTART.
  bool continues() const;
  /// The checkpoint to continue from: --restart, the file on the RESTART card, or
  /// NAME.ckpt.h5.
  std::string checkpoint() const;
  output::RunIdentity identity(const Model& model) const;

  /// Loads the checkpoint of a RESTART deck, or of this deck if it was stopped earlier
  /// or goes on to --until. Throws files::FileError if it cannot be continued.
  Model load();
  /// A faulty deck that does not begin with RESTART is checked as a new run, because no
  /// checkpoint belongs to it.
  bool loads() const {
    return continues() || (options.restart && !diagnostics.has_errors());
  }
  /// Index of the first command after the checkpoint.
  std::size_t first_command() const {
    return resumes ? static_cast<std::size_t>(from.progress.card) : 0;
  }
  /// Whether it is the MOTION card that --until has added.
  bool is_extension(std::size_t command) const {
    return options.until && command == end;
  }
  /// Whether the deck itself has a MOTION, CYCLE or SOLVE at this index or later.
  bool passes_time_from(std::size_t command) const;
  /// The number of MOTION, CYCLE, SOLVE and FOS cards before this index.
  long motions_before(std::size_t command) const;
  /// Whether the deck has SOLVE, LOCDAMP or KINDAMP, or a history of unbalanced forces.
  /// Its results then have them (docs/rest.md#the-ratio).
  bool asks_for_equilibrium() const;
  /// Whether all SOLVE cards of the deck are before this index; empty if it has none.
  std::optional<bool> solved_before(std::size_t command) const;
  /// Number of commands that the deck itself has.
  std::size_t own_commands() const {
    return deck.commands.size() - (options.until ? 1 : 0);
  }

  const RunOptions& options;
  std::string text;
  deck::Diagnostics diagnostics;
  deck::Deck deck;
  std::size_t end;    ///< index of STOP, or behind the last card
  std::string files;  ///< hashes of the files on the cards, compared by a restart
  std::string name;
  output::CheckpointInfo from;  ///< valid once loaded
  bool resumes = false;         ///< the same deck resumes where it stopped
  ExitCode fault = deck_error;  ///< exit code of a failed check

 private:
  /// Adds the card of RunOptions::last_card before STOP.
  void add_last_card();
  bool is_in_deck() const;
  /// Whether the checkpoint's run had begun the card of --until.
  bool was_extended() const;
  void place_at_end(const Model& model);
  std::string overrides() const;
};

}  // namespace blocks::run
