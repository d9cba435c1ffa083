// What a card acts on.
#pragma once

#include <string>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "model/model.hpp"
#include "run/builder/builder_state.hpp"

namespace blocks::run {

/// The present card, the model that it changes, what the cards before it mean, and the
/// messages.
struct Context {
  Model& model;
  deck::Diagnostics& diagnostics;
  BuilderState& state;
  const deck::Command& command;
  Settings& settings = model.settings;
  Blocks& blocks = model.blocks;

  void error(deck::SourceLocation where, const std::string& message,
             const std::string& hint = {}) const {
    diagnostics.error(where, command.name, message, hint);
  }
  void warning(deck::SourceLocation where, const std::string& message,
               const std::string& hint = {}) const {
    diagnostics.warning(where, command.name, message, hint);
  }
  /// Messages at the keyword of the card.
  void error(const std::string& message, const std::string& hint = {}) const {
    error(command.where, message, hint);
  }
  void warning(const std::string& message, const std::string& hint = {}) const {
    warning(command.where, message, hint);
  }
  /// Records what the card has done: "BOND in line 9 at time 0: " and the text.
  void note(const std::string& text) const;

  /// The context of an earlier card that is checked now.
  Context of(const deck::Command& other) const {
    return {model, diagnostics, state, other};
  }
  /// Whether a MOTION, CYCLE or SOLVE lies before the present card.
  bool has_moved() const { return state.section > 0 || model.steps > 0; }
  /// How many blocks are missing at most above this card, because their cards failed.
  long max_missing() const { return state.numbers.max_missing(command.where.line); }
};

}  // namespace blocks::run
