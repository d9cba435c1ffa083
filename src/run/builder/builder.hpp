// Turns the cards of a deck into a model. It executes every card except those that
// advance the time (MOTION, CYCLE, SOLVE, FOS) or write files (DUMP, SAVE). It depends
// on deck and model, not on the time loop.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "deck/commands.hpp"
#include "deck/diagnostics.hpp"
#include "model/model.hpp"
#include "run/builder/builder_state.hpp"
#include "run/builder/context.hpp"

namespace blocks::run {

class Builder {
 public:
  /// Errors and warnings go to the diagnostics. A `state` after a card lets this
  /// builder go on where another one had it, with a copy of its model.
  Builder(Model& model, deck::Diagnostics& diagnostics, BuilderState state);

  const BuilderState& state() const { return state_; }
  /// Returns the notes on mesh files, shared corners and removed or freed blocks since
  /// the last call, one per line.
  std::vector<std::string> take_notes() { return std::exchange(state_.notes, {}); }
  const SharedCertificate& certificate() const { return state_.certificate; }

  /// Executes the next card of the deck. After an error the model is unchanged.
  void apply(const deck::Command& command);

  /// Continues a resumed run at cards[next]. The cards before it made the model.
  /// `overlaps` are the overlaps reported so far.
  void go_on(const std::vector<deck::Command>& cards, std::size_t next,
             const std::vector<geometry::BlockOverlap>& overlaps);

  /// Steps are made from the present card on, a MOTION, CYCLE, SOLVE or FOS. Without
  /// this call, no block moves, and the cards after it act on blocks that may be
  /// elsewhere in a run.
  void begin_to_move();

  /// Checks what must hold before MOTION and CYCLE (checks.hpp). `in_place` means that
  /// no MOTION, CYCLE or SOLVE lies between, so the blocks are where they will be at
  /// that moment.
  void check_before_motion(const deck::Command& command, bool in_place);
  /// After errors of cards, checks before the first motion what does not depend on
  /// these: the planes and the time step, if no card that makes blocks has failed.
  void check_despite_errors(const deck::Command& command);
  /// The same checks of blocks and planes at the end of a deck, when no more time
  /// passes.
  void check_without_motion(const deck::Command& last);
  /// Checks the blocks named by OUTPUT and HISTORY, which may be made after these
  /// cards. Call it when all cards are read.
  void check_output_blocks();
  /// Tests the rules of plausibility about the blocks before a motion. The blocks are
  /// taken where the deck puts them, so the run need not repeat this.
  void check_plausibility(const deck::Command& motion);
  /// Tests the rules of plausibility about the whole deck, when all cards are read. A
  /// model that a program drives needs no MOTION.
  void check_deck(std::span<const deck::Command> cards, bool driven);

 private:
  Context context(const deck::Command& command) {
    return {model_, diagnostics_, state_, command};
  }
  /// Takes in the blocks that have split off since the last card. They are not checked
  /// as blocks that a card has made.
  void take_in_pieces();
  Plan plan(std::span<const deck::Command> cards) const;

  Model& model_;
  deck::Diagnostics& diagnostics_;
  BuilderState state_;
};

}  // namespace blocks::run
