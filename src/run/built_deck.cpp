#include "run/built_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>
#include <variant>

#include "files/file_error.hpp"
#include "run/builder/builder.hpp"
#include "run/executor/saved_state.hpp"
#include "run/support/cut_progress.hpp"
#include "run/support/interrupt.hpp"

namespace blocks::run {
namespace {

/// Loads the checkpoint of a deck to be checked. If that fails, reports it at the
/// RESTART card, and the model stays empty. Throws files::FileError if --restart alone
/// is at fault.
Model load_to_check(Job& job) {
  try {
    return job.load();
  } catch (const files::FileError& fault) {
    if (job.options.restart && !job.diagnostics.has_errors())
      throw;
    const deck::Command& command = job.deck.commands.front();
    const auto& card = std::get<deck::Restart>(command.card);
    job.diagnostics.error(
        card.file.given ? card.file.where : command.where, command.name, fault.what(),
        "name a checkpoint, with or without .ckpt.h5, such as that of "
        "a SAVE card; --restart FILE replaces the name");
    job.fault = file_error;
    job.from = {};
    job.resumes = false;
    job.deck.unread.push_back({command.where, command.name, std::nullopt,
                               deck::UnreadCard::any_number_of_blocks});
    return {};
  }
}

BuildOptions checking(const Job& job) {
  BuildOptions options = job.build_options();
  options.check_progress = [shown = CutProgress(job.options.quiet)](
                               const std::string& step, double part) mutable {
    shown(CutProgress::check, step, part);
  };
  return options;
}

bool writes_state(const deck::Command& command) {
  return std::holds_alternative<deck::Dump>(command.card) ||
         std::holds_alternative<deck::Save>(command.card);
}

class Building {
 public:
  explicit Building(Job& job)
      : job_(job), cards_(job.deck.commands),
        model_(job.loads() ? load_to_check(job) : Model()),
        builder_(model_, job.diagnostics, {model_, cards_, checking(job)}),
        first_(job.first_command()), in_place_(job.motions_before(first_) == 0),
        built_to_(cards_.size()) {
    if (job.resumes)
      builder_.go_on(cards_, first_, job.from.progress.overlaps);
  }

  std::optional<BuiltDeck> built() {
    if (job_.resumes)
      add_stage(first_);
    for (std::size_t i = first_; i < cards_.size(); ++i) {
      stop_if_interrupted();
      act(i);
    }
    if (!state_)
      end_without_motion();
    check_whole_deck();
    if (has_errors())
      return {};
    take_notes();
    if (const int later = model_.blocks.size() - blocks_at_start_; later > 0)
      notes_.push_back(
          fmt::format("blocks made after the first MOTION, CYCLE or SOLVE: {}; the "
                      "run checks them for overlaps",
                      later));
    if (is_unchanged_)
      stages_.back().model = std::move(model_);
    return BuiltDeck{std::move(stages_), built_to_, *std::move(state_),
                     std::move(notes_)};
  }

 private:
  bool has_errors() const { return job_.diagnostics.has_errors(); }

  std::vector<std::string> take_notes() {
    std::vector<std::string> taken = builder_.take_notes();
    notes_.insert(notes_.end(), taken.begin(), taken.end());
    return taken;
  }

  void act(std::size_t i) {
    const deck::Command& command = cards_[i];
    const bool moves = deck::passes_time(command);
    if (!state_ && (moves || writes_state(command)))
      add_stage(i);
    builder_.apply(command);
    changed_ = changed_ || changes_model(command);
    if (!moves)
      return;
    if (!has_errors()) {
      builder_.check_plausibility(command);
      // A run checks later motions, when the blocks are where they move from.
      builder_.check_before_motion(command, in_place_);
    } else if (in_place_) {
      builder_.check_despite_errors(command);
    }
    in_place_ = false;
    if (!state_) {
      state_ = builder_.state();
      built_to_ = i;
    }
  }

  /// The model is copied only if cards change it further.
  void add_stage(std::size_t card) {
    if (has_errors() || (!stages_.empty() && !changed_))
      return;
    is_unchanged_ = std::none_of(cards_.begin() + static_cast<std::ptrdiff_t>(card),
                                 cards_.end(), changes_model);
    stages_.push_back({card, is_unchanged_ ? Model() : model_, take_notes(), changed_});
    changed_ = false;
    blocks_at_start_ = model_.blocks.size();
  }

  void end_without_motion() {
    add_stage(cards_.size());
    if (in_place_ && !has_errors() && !cards_.empty())
      builder_.check_without_motion(cards_.back());
    state_ = builder_.state();
  }

  void check_whole_deck() {
    builder_.check_output_blocks();
    check_saves(job_.deck, job_.name, job_.continues() ? job_.checkpoint() : "",
                job_.diagnostics);
    if (!has_errors())
      builder_.check_deck(cards_, job_.options.driven);
  }

  Job& job_;
  const std::vector<deck::Command>& cards_;
  Model model_;
  Builder builder_;
  std::size_t first_;  ///< index of the first card that acts
  bool in_place_;      ///< no block has moved, so all are where cards have put them
  std::vector<Stage> stages_;
  std::vector<std::string> notes_;
  bool changed_ = false;       ///< cards have acted since the last stage
  bool is_unchanged_ = false;  ///< no card changes the model after the last stage
  int blocks_at_start_ = 0;    ///< blocks of the last stage
  std::size_t built_to_;
  std::optional<BuilderState> state_;  ///< after the first card with which time passes
};

}  // namespace

bool changes_model(const deck::Command& command) {
  return !deck::passes_time(command) &&
         !std::holds_alternative<deck::Restart>(command.card) &&
         !std::holds_alternative<deck::Save>(command.card) &&
         !std::holds_alternative<deck::Dump>(command.card) &&
         !std::holds_alternative<deck::Stop>(command.card);
}

std::optional<BuiltDeck> build(Job& job) {
  try {
    return Building(job).built();
  } catch (const Interrupted&) {
    std::fputs(nothing_written, stderr);
    job.fault = interrupted;
    return {};
  }
}

}  // namespace blocks::run
