// What a Simulation holds: the model, its working memory, and the executor of cards.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "blocks/simulation.hpp"
#include "deck/parser.hpp"
#include "dynamics/stepper.hpp"
#include "geometry/overlap.hpp"
#include "library/results_in_use.hpp"
#include "run/builder/builder.hpp"
#include "run/watch/crack_watch.hpp"
#include "run/watch/motion_watch.hpp"

namespace blocks {

namespace library {

/// Functions that are called in the course of steps and cards; they may be empty.
struct Hooks {
  /// After each step that was sound. What it throws ends the steps.
  std::function<void()> after_step;
  /// Before the columns of Model::blocks get other memory: cards add blocks, or blocks
  /// split. Until then, pointers to them stay valid.
  std::function<void()> before_new_blocks;
};

}  // namespace library

struct Simulation::State {
  State(std::string deck_name, std::string deck_folder, std::string deck, int threads,
        Motions motions, library::Hooks given_hooks = {});

  /// Executes all cards. Throws DeckError with all their errors.
  void execute(const deck::Deck& deck, deck::Diagnostics& diagnostics);
  void step(long count, bool read);
  /// Makes the steps of a SOLVE card, as a run does.
  void solve(const deck::Solve& card, int line);
  /// Makes the trials of a FOS card, as a run does. The blocks stay as they are.
  void factor_of_safety(const deck::Fos& card, int line);
  /// Throws UnsoundRun if an earlier step was unsound.
  void must_be_sound() const;
  /// Throws std::logic_error if the contacts of the last step are not known.
  void must_be_read() const;
  /// The index of a block, from its number.
  int index(int block) const;
  /// The model after the last step.
  Model& current() {
    stepper.up_to_date();
    return model;
  }
  /// The blocks after the last step.
  Blocks& blocks() {
    stepper.bring_out_blocks();
    return model.blocks;
  }
  /// To be called when velocities or loads of current() have been changed.
  void take_velocities_and_loads() {
    stepper.take_velocities_and_loads();
    ++changes;
  }

  library::Hooks hooks;
  std::string name, folder, text;
  Model model;
  dynamics::Workspace work;
  dynamics::Stepper stepper{model, work};
  std::vector<geometry::BlockOverlap> overlaps;  ///< reported by the certificate
  std::vector<std::string> warnings;
  std::string unsound;  ///< why a step was unsound; empty if none was
  long changes = 0;     ///< number of calls that changed the model, steps left out
  bool contacts_known = true;  ///< those of the last step
  std::map<std::filesystem::path, library::ResultsInUse> results;  ///< by path
  std::set<std::filesystem::path> checkpoints;  ///< that were written

 private:
  run::MotionWatch watch_;
  run::CrackWatch crack_watch_;
  double half_depth_ = 0.0;  ///< [L] half the least depth of a convex block
  void prepare(Model& on);
  /// Makes one step. Throws UnsoundRun if it was unsound.
  void make_step(bool reads);
  void keep_warnings(const deck::Diagnostics& diagnostics);
  /// What the cards before the first motion have made.
  struct Beginning {
    std::size_t card;  ///< index of the first card with which time passes
    Model model;
    run::BuilderState builder;
    int judged;  ///< number of blocks before the cards
  };
  /// Executes all cards on a copy of the model, so that no time passes. Returns nothing
  /// if they have no motion. Throws DeckError if there were errors.
  std::optional<Beginning> check(Model& trial, const deck::Deck& deck,
                                 deck::Diagnostics& diagnostics);
  /// Goes on with the cards from the first motion on. Throws DeckError.
  void play(const deck::Deck& deck, Beginning beginning, deck::Diagnostics diagnostics);
  /// Replaces the model.
  void take(Model&& other);
  void load(Model& into, const deck::Command& command, deck::Diagnostics& diagnostics);
  void make_steps(const deck::Command& command);
  void end_cards(const run::Builder& builder, const deck::Diagnostics& diagnostics);
};

}  // namespace blocks
