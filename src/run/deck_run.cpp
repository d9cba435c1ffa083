#include "run/deck_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <utility>
#include <variant>

#include "dynamics/support/memory_pages.hpp"
#include "files/file_tools.hpp"
#include "files/name_lock.hpp"
#include "model/equilibrium.hpp"
#include "model/words/certificate_text.hpp"
#include "run/builder/builder.hpp"
#include "run/executor/continuation_hint.hpp"
#include "run/executor/executor.hpp"
#include "run/executor/saved_state.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

using dynamics::Profile;

const char* status_of(Outcome outcome) {
  switch (outcome) {
  case Outcome::finished:
  case Outcome::end_time:
    return "done";
  case Outcome::unsound_deck:
    return "deck error";
  case Outcome::unsound:
    return "unsound";
  case Outcome::time_limit:
    return "time limit";
  case Outcome::step_limit:
    return "step limit";
  case Outcome::interrupted:
    return "interrupted";
  }
  return "";
}

ExitCode code_of(Outcome outcome) {
  switch (outcome) {
  case Outcome::finished:
  case Outcome::end_time:
    return done;
  case Outcome::unsound_deck:
    return deck_error;
  case Outcome::unsound:
    return unsound_run;
  case Outcome::time_limit:
  case Outcome::step_limit:
    return time_limit;
  case Outcome::interrupted:
    return interrupted;
  }
  return internal_error;
}

RunFiles files_of(const Job& job, const Model& model) {
  const output::RunIdentity identity = job.identity(model);
  if (job.resumes)
    return RunFiles::resumed(job.name, identity, job.from, job.checkpoint());
  if (job.continues())
    return RunFiles::behind(job.name, identity, job.from, job.checkpoint());
  return {job.name, identity};
}

bool is_same(const deck::Diagnostic& a, const deck::Diagnostic& b) {
  return a.where.line == b.where.line && a.where.column == b.where.column &&
         a.message == b.message;
}

class DeckRun {
 public:
  DeckRun(Job& job, BuiltDeck built, Console& console)
      : job_(job), cards_(job.deck.commands), console_(console),
        built_to_(built.built_to), said_by_check_(job.diagnostics.all().size()),
        stages_(std::move(built.stages)), model_(std::move(stages_.front().model)),
        files_(files_of(job, model_)), executor_(model_, files_, console, job.options),
        builder_(model_, job.diagnostics, std::move(built.builder)),
        motion_(job.motions_before(stages_.front().card)),
        motions_(job.motions_before(cards_.size())) {
    builder_.begin_to_move();
  }

  ExitCode run(const std::vector<std::string>& warnings) {
    open(warnings);
    const Outcome outcome = play();
    console_.clear_progress();
    executor_.finish();
    close(outcome);
    return code_of(outcome);
  }

 private:
  void open(const std::vector<std::string>& warnings) {
    if (!files_.put_aside().empty())
      console_.warn(files_.put_aside());
    if (job_.asks_for_equilibrium() || is_damped_to_rest(model_.settings))
      files_.results().include_unbalanced();
    if (job_.solved_before(0))
      console_.show_ratio();
    if (job_.resumes) {
      executor_.resume(job_.from.progress);
      if (job_.from.progress.finished && !job_.options.until)
        console_.note(continuation_hint(job_.checkpoint(), model_.time));
      return;
    }
    for (const std::string& warning : warnings)
      executor_.remember(warning);
    if (builder_.certificate())
      files_.message("certificate: " + full_text(*builder_.certificate()));
  }

  /// Acts on the cards from the first stage on, because those before it have acted.
  Outcome play() {
    for (std::size_t i = stages_.front().card; i < cards_.size(); ++i) {
      executor_.set_card(static_cast<long>(i));
      begin_stage_at(i);
      if (model_.started && executor_.steps_to_end() == 0 && job_.passes_time_from(i))
        return Outcome::end_time;
      if (i > built_to_ && !build(cards_[i]))
        return Outcome::unsound_deck;
      if (deck::passes_time(cards_[i]) && !prepare_to_move(cards_[i]))
        return Outcome::unsound_deck;
      if (std::holds_alternative<deck::Stop>(cards_[i].card))
        break;
      if (const Outcome outcome = execute(i); outcome != Outcome::finished)
        return outcome;
    }
    begin_stage_at(cards_.size());
    return motions_ > 0 && !is_sound_in_place(cards_.back()) ? Outcome::unsound_deck
                                                             : Outcome::finished;
  }

  /// Takes the model of the stage that begins at this card, if there is one.
  void begin_stage_at(std::size_t card) {
    if (stage_ == stages_.size() || stages_[stage_].card != card)
      return;
    Stage& stage = stages_[stage_];
    if (stage_++ > 0)  // the first one is there from the beginning
      model_ = std::move(stage.model);
    if (stage.changed)
      executor_.card_has_acted();
    for (const std::string& note : stage.notes)
      files_.message(note);
  }

  /// Lets a card act on blocks that have moved. It may find others than the check did.
  /// Returns false if there were errors.
  bool build(const deck::Command& command) {
    const Profile::Timer timer(executor_.profile(), Profile::building);
    const std::size_t before = job_.diagnostics.all().size();
    builder_.apply(command);
    if (changes_model(command))
      executor_.card_has_acted();
    if (!tell_new(before, said_by_check_))
      return false;
    for (const std::string& note : builder_.take_notes())
      files_.message(note);
    return true;
  }

  /// Checks what must hold before the steps of a card. The first motion has been
  /// checked, and so has a card that was begun before a restart. Returns false if there
  /// were errors.
  bool prepare_to_move(const deck::Command& command) {
    const Profile::Timer timer(executor_.profile(), Profile::building);
    if (motion_ > 0 && !executor_.begun() && !is_sound_in_place(command))
      return false;
    dynamics::release_free_pages();
    if (builder_.certificate())
      executor_.set_overlaps(builder_.certificate()->overlaps);
    const auto share = [this](long motions) {
      return static_cast<double>(motions) / static_cast<double>(motions_);
    };
    executor_.set_share(share(motion_), share(motion_ + 1));
    ++motion_;
    return true;
  }

  /// Checks a later MOTION, CYCLE or SOLVE at the present positions of the blocks, or
  /// the blocks made after the last one. Returns false if there were errors.
  bool is_sound_in_place(const deck::Command& command) {
    const std::size_t before = job_.diagnostics.all().size();
    const int proved = builder_.certificate() ? builder_.certificate()->blocks : 0;
    if (deck::passes_time(command))
      builder_.check_before_motion(command, true);
    else
      builder_.check_without_motion(command);
    if (const auto& now = builder_.certificate(); now && now->blocks != proved)
      files_.message("certificate: " + full_text(*now));
    return tell_new(before, 0);
  }

  /// Reports the diagnostics from index `before` on, except those that are among the
  /// first `known`. Returns false if there were errors.
  bool tell_new(std::size_t before, std::size_t known) {
    bool sound = true;
    const std::vector<deck::Diagnostic>& all = job_.diagnostics.all();
    for (std::size_t i = before; i < all.size(); ++i) {
      if (std::any_of(
              all.begin(), all.begin() + static_cast<std::ptrdiff_t>(known),
              [&](const deck::Diagnostic& one) { return is_same(one, all[i]); }))
        continue;
      std::fputs(job_.diagnostics.format(all[i]).c_str(), stderr);
      executor_.remember(fmt::format("{}: {}", all[i].card, all[i].message));
      sound = sound && all[i].severity != deck::Severity::error;
    }
    return sound;
  }

  /// Makes the steps of a card, or writes its files.
  Outcome execute(std::size_t i) {
    const deck::Command& command = cards_[i];
    if (job_.is_extension(i))
      return model_.started && executor_.steps_to_end() == 0
                 ? Outcome::finished
                 : executor_.motion(job_.options.until.value() - model_.time);
    if (const auto* card = std::get_if<deck::Motion>(&command.card))
      return executor_.motion(card->dt.value);
    if (const auto* cycle = std::get_if<deck::Cycle>(&command.card))
      return executor_.cycle(cycle->ncycle.value);
    if (const auto* solve = std::get_if<deck::Solve>(&command.card))
      return executor_.solve(*solve, command.where.line);
    if (const auto* fos = std::get_if<deck::Fos>(&command.card))
      return executor_.factor_of_safety(*fos, command.where.line);
    if (std::holds_alternative<deck::Dump>(command.card))
      executor_.dump();
    else if (const auto* save = std::get_if<deck::Save>(&command.card))
      executor_.save(saved_path(job_.name, save->name.value));
    return Outcome::finished;
  }

  void close(Outcome outcome) {
    output::RunReport report;
    report.warnings = executor_.warnings();
    report.certificate = builder_.certificate();
    if (job_.options.audit_every > 0)
      report.audit = executor_.audit().totals();
    report.wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began_)
            .count();
    report.status = status_of(outcome);
    output::Progress progress = executor_.progress();
    progress.finished = outcome == Outcome::finished;
    if (progress.finished)  // with the card of --until, if there is one
      progress.card = static_cast<long>(cards_.size());
    report.solved = job_.solved_before(static_cast<std::size_t>(progress.card));
    long good = -1;  // step of the good state kept from an unsound run
    {
      const Profile::Timer timer(executor_.profile(), Profile::output);
      if (outcome == Outcome::unsound)
        good = executor_.save_good_state();
      files_.close(model_, report, progress, executor_.has_changed());
    }
    tell_end(report, good);
  }

  void tell_end(const output::RunReport& report, long good) {
    console_.note(fmt::format("{} after {}, t {:g}, in {:.2f} s: {}, {}, {}{}",
                              report.status, counted(model_.steps, "step"), model_.time,
                              report.wall_seconds, job_.name + ".out",
                              files_.results_path(),
                              std::filesystem::exists(files_.checkpoint_path())
                                  ? files_.checkpoint_path() + ", "
                                  : "",
                              files_.summary_path()));
    if (good >= 0)
      console_.note(
          fmt::format("the last good state that was kept is that of step {}, in {}",
                      good, files_.checkpoint_path()));
    executor_.tell_profile();
    if (job_.options.json) {
      std::ifstream summary(files_.summary_path());
      std::cout << summary.rdbuf() << std::flush;
    }
  }

  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  Job& job_;
  const std::vector<deck::Command>& cards_;
  Console& console_;
  std::size_t built_to_;
  std::size_t said_by_check_;  ///< number of messages of the check
  std::vector<Stage> stages_;
  std::size_t stage_ = 0;  ///< index of the next stage
  Model model_;
  RunFiles files_;
  Executor executor_;
  Builder builder_;
  long motion_;   ///< cards with which time passes before the present one
  long motions_;  ///< in the whole deck
};

}  // namespace

ExitCode run_built(Job& job, BuiltDeck built, Console& console,
                   const std::vector<std::string>& warnings) {
  files::create_folder_of(job.name);
  const files::NameLock lock(job.name, job.name + ".vtkhdf");
  return DeckRun(job, std::move(built), console).run(warnings);
}

}  // namespace blocks::run
