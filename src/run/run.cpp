#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <utility>

#include "dynamics/support/memory_pages.hpp"
#include "dynamics/time_step.hpp"
#include "model/counted.hpp"
#include "model/equilibrium.hpp"
#include "output/file_tools.hpp"
#include "output/name_lock.hpp"
#include "run/builder/builder.hpp"
#include "run/executor/continuation_hint.hpp"
#include "run/executor/executor.hpp"
#include "run/executor/saved_state.hpp"
#include "run/job.hpp"
#include "run/reports/check_report.hpp"
#include "run/support/cut_progress.hpp"
#include "run/support/deck_file.hpp"
#include "run/support/interrupt.hpp"

namespace blocks::run {
namespace {

using dynamics::Profile;

constexpr const char* nothing_written = "blocks: interrupted; no file was written\n";

/// Loads the checkpoint of a deck to be checked. If that fails, reports it at the
/// RESTART card, and the model stays empty. Throws output::FileError if --restart alone
/// is at fault.
Model load_to_check(Job& job) {
  try {
    return job.load();
  } catch (const output::FileError& fault) {
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

/// As check(), but throws Interrupted. `start` receives the model at the first
/// MOTION, CYCLE or SOLVE, or at the end if there is none. `notes` receives the notes
/// on what cards did. Returns false if there were errors.
bool check_cards(Job& job, Model& start, std::vector<std::string>& notes) {
  Model model;
  if (job.loads())
    model = load_to_check(job);
  BuildOptions options = job.build_options();
  options.moves = false;
  options.check_progress = [shown = CutProgress(job.options.quiet)](
                               const std::string& step, double part) mutable {
    shown(CutProgress::check, step, part);
  };
  Builder builder(model, job.diagnostics, job.deck.commands, std::move(options));
  if (job.resumes)
    builder.go_on(job.deck.commands, job.first_command(), job.from.progress.overlaps);
  bool has_moved = false;
  for (std::size_t i = job.first_command(); i < job.deck.commands.size(); ++i) {
    const deck::Command& command = job.deck.commands[i];
    stop_if_interrupted();
    builder.apply(command);
    if (!deck::passes_time(command))
      continue;
    if (!job.diagnostics.has_errors()) {
      builder.check_plausibility(command);
      // A resumed run checks in place itself.
      builder.check_before_motion(command, !has_moved && !job.resumes);
    } else if (!has_moved && !job.resumes) {
      builder.check_despite_errors(command);
    }
    if (!std::exchange(has_moved, true))
      start = model;
  }
  if (!has_moved && !job.resumes && !job.diagnostics.has_errors() &&
      !job.deck.commands.empty())
    builder.check_without_motion(job.deck.commands.back());
  builder.check_output_blocks();
  check_saves(job.deck, job.name, job.continues() ? job.checkpoint() : "",
              job.diagnostics);
  if (!job.diagnostics.has_errors())
    builder.check_deck(job.deck.commands, job.options.driven);
  notes = builder.take_notes();
  if (!has_moved)
    start = std::move(model);
  else if (const int later = model.blocks.size() - start.blocks.size(); later > 0)
    notes.push_back(
        fmt::format("blocks made after the first MOTION, CYCLE or SOLVE: {}; the "
                    "run checks them for overlaps",
                    later));
  job.certificate = builder.certificate();
  return !job.diagnostics.has_errors();
}

/// Executes every card without making steps. Returns false if there were errors, or an
/// interrupt. start, notes: as in check_cards().
bool check(Job& job, Model& start, std::vector<std::string>& notes) {
  try {
    return check_cards(job, start, notes);
  } catch (const Interrupted&) {
    std::fputs(nothing_written, stderr);
    job.fault = interrupted;
    return false;
  }
}

bool is_same(const deck::Diagnostic& a, const deck::Diagnostic& b) {
  return a.where.line == b.where.line && a.where.column == b.where.column &&
         a.message == b.message;
}

/// Reports the diagnostics from index `before` on, except those in `known`. Returns
/// false if there were errors.
bool tell_new(const deck::Diagnostics& said, std::size_t before, Executor& executor,
              const std::vector<deck::Diagnostic>& known = {}) {
  bool sound = true;
  for (std::size_t i = before; i < said.all().size(); ++i) {
    const deck::Diagnostic& diagnostic = said.all()[i];
    if (std::any_of(known.begin(), known.end(), [&](const deck::Diagnostic& one) {
          return is_same(one, diagnostic);
        }))
      continue;
    std::fputs(said.format(diagnostic).c_str(), stderr);
    executor.remember(fmt::format("{}: {}", diagnostic.card, diagnostic.message));
    sound = sound && diagnostic.severity != deck::Severity::error;
  }
  return sound;
}

/// Checks a later MOTION, CYCLE or SOLVE at the present positions of the blocks, or the
/// blocks made after the last one. Returns false if there were errors.
bool sound_in_place(Builder& builder, deck::Diagnostics& said,
                    const deck::Command& command, Executor& executor, RunFiles& files) {
  const std::size_t before = said.all().size();
  const int proved = builder.certificate() ? builder.certificate()->blocks : 0;
  if (deck::passes_time(command))
    builder.check_before_motion(command, true);
  else
    builder.check_without_motion(command);
  if (const auto& now = builder.certificate(); now && now->blocks != proved)
    files.message("certificate: " + full_text(*now));
  return tell_new(said, before, executor);
}

/// Whether the card may change the model by itself, without steps.
bool changes_model(const deck::Command& command) {
  return !deck::passes_time(command) &&
         !std::holds_alternative<deck::Save>(command.card) &&
         !std::holds_alternative<deck::Dump>(command.card) &&
         !std::holds_alternative<deck::Stop>(command.card);
}

/// Runs the deck. Returns an ExitCode.
int execute(Job& job, Console& console, const std::vector<std::string>& warnings) {
  const auto began = std::chrono::steady_clock::now();
  output::create_folder_of(job.name);
  const output::NameLock lock(job.name, job.name + ".vtkhdf");
  Model model;
  if (job.loads())
    model = job.load();

  // The check has already shown the errors and warnings of the cards.
  deck::Diagnostics said = job.diagnostics.without_messages();
  Builder builder(model, said, job.deck.commands, job.build_options());
  // The preliminary cards set the title and the seed, which are needed before anything
  // is written.
  std::size_t next = job.first_command();
  for (; !job.resumes && next < job.deck.commands.size(); ++next) {
    const deck::Command& command = job.deck.commands[next];
    builder.apply(command);
    if (std::holds_alternative<deck::End>(command.card) ||
        std::holds_alternative<deck::Restart>(command.card)) {
      ++next;
      break;
    }
  }
  const output::RunIdentity identity = job.identity(model);
  RunFiles files =
      job.resumes ? RunFiles::resumed(job.name, identity, job.from, job.checkpoint())
      : job.continues()
          ? RunFiles::behind(job.name, identity, job.from, job.checkpoint())
          : RunFiles(job.name, identity);
  if (!files.put_aside().empty())
    console.warn(files.put_aside());
  if (job.asks_for_equilibrium() || is_damped_to_rest(model.settings))
    files.results().include_unbalanced();
  if (job.solved_before(0))
    console.show_ratio();
  Executor executor(model, files, console, job.options);
  if (job.resumes) {
    builder.go_on(job.deck.commands, job.first_command(), job.from.progress.overlaps);
    executor.resume(job.from.progress);
    if (job.from.progress.finished && !job.options.until)
      console.note(continuation_hint(job.checkpoint(), model.time));
  } else {
    for (const std::string& warning : warnings)
      executor.remember(warning);
    if (job.certificate)
      files.message("certificate: " + full_text(*job.certificate));
  }
  const auto motions = static_cast<double>(std::count_if(
      job.deck.commands.begin(), job.deck.commands.end(), deck::passes_time));
  double motion = static_cast<double>(
      std::count_if(job.deck.commands.begin(),
                    job.deck.commands.begin() + static_cast<std::ptrdiff_t>(next),
                    deck::passes_time));
  Outcome outcome = Outcome::finished;
  for (; next < job.deck.commands.size() && outcome == Outcome::finished; ++next) {
    const deck::Command& command = job.deck.commands[next];
    executor.set_card(static_cast<long>(next));
    if (model.started && executor.steps_to_end() == 0 && job.passes_time_from(next)) {
      outcome = Outcome::end_time;
      break;
    }
    {
      const Profile::Timer timer(executor.profile(), Profile::building);
      const std::size_t before = said.all().size();
      builder.apply(command);
      if (changes_model(command))
        executor.card_has_acted();
      // A card that acts on blocks in motion may find others than the check did.
      if (!tell_new(said, before, executor, job.diagnostics.all())) {
        outcome = Outcome::unsound_deck;
        break;
      }
    }
    for (const std::string& note : builder.take_notes())
      files.message(note);
    if (deck::passes_time(command)) {
      const Profile::Timer timer(executor.profile(), Profile::building);
      if (executor.begun()) {
        // The card was checked when it began.
      } else if (motion == 0.0) {
        builder.begin_to_move(job.certificate);
      } else if (!sound_in_place(builder, said, command, executor, files)) {
        outcome = Outcome::unsound_deck;
        break;
      }
      dynamics::release_free_pages();
      if (builder.certificate())
        executor.set_overlaps(builder.certificate()->overlaps);
      executor.set_share(motion / motions, (motion + 1.0) / motions);
      motion += 1.0;
    }
    if (job.is_extension(next))
      outcome = model.started && executor.steps_to_end() == 0
                    ? Outcome::finished
                    : executor.motion(job.options.until.value() - model.time);
    else if (const auto* card = std::get_if<deck::Motion>(&command.card))
      outcome = executor.motion(card->dt.value);
    else if (const auto* cycle = std::get_if<deck::Cycle>(&command.card))
      outcome = executor.cycle(cycle->ncycle.value);
    else if (const auto* solve = std::get_if<deck::Solve>(&command.card))
      outcome = executor.solve(*solve, command.where.line);
    else if (const auto* fos = std::get_if<deck::Fos>(&command.card))
      outcome = executor.factor_of_safety(*fos, command.where.line);
    else if (std::holds_alternative<deck::Dump>(command.card))
      executor.dump();
    else if (const auto* save = std::get_if<deck::Save>(&command.card))
      executor.save(saved_path(job.name, save->name.value));
    else if (std::holds_alternative<deck::Stop>(command.card))
      break;
  }
  if (motion > 0.0 && outcome == Outcome::finished &&
      !sound_in_place(builder, said, job.deck.commands.back(), executor, files))
    outcome = Outcome::unsound_deck;
  console.clear_progress();
  executor.finish();

  output::RunReport report;
  report.warnings = executor.warnings();
  report.certificate = motion > 0.0 ? builder.certificate() : job.certificate;
  if (job.options.audit_every > 0)
    report.audit = executor.audit().totals();
  report.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  report.status = outcome == Outcome::finished       ? "done"
                  : outcome == Outcome::end_time     ? "done"
                  : outcome == Outcome::unsound_deck ? "deck error"
                  : outcome == Outcome::unsound      ? "unsound"
                  : outcome == Outcome::time_limit   ? "time limit"
                  : outcome == Outcome::step_limit   ? "step limit"
                                                     : "interrupted";
  long good = -1;  // step of the good state kept from an unsound run
  output::Progress progress = executor.progress();
  progress.finished = outcome == Outcome::finished;
  if (progress.finished)  // with the card of --until, if there is one
    progress.card = static_cast<long>(job.deck.commands.size());
  report.solved = job.solved_before(static_cast<std::size_t>(progress.card));
  {
    const Profile::Timer timer(executor.profile(), Profile::output);
    if (outcome == Outcome::unsound)
      good = executor.save_good_state();
    files.close(model, report, progress, executor.has_changed());
  }
  console.note(fmt::format("{} after {}, t {:g}, in {:.2f} s: {}, {}, {}{}",
                           report.status, counted(model.steps, "step"), model.time,
                           report.wall_seconds, job.name + ".out", files.results_path(),
                           std::filesystem::exists(files.checkpoint_path())
                               ? files.checkpoint_path() + ", "
                               : "",
                           files.summary_path()));
  if (good >= 0)
    console.note(
        fmt::format("the last good state that was kept is that of step {}, in {}", good,
                    files.checkpoint_path()));
  executor.tell_profile();
  if (job.options.json) {
    std::ifstream summary(files.summary_path());
    std::cout << summary.rdbuf() << std::flush;
  }
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

void tell(const Job& job) {
  // fmt::print would throw if nothing reads standard error, and end the run.
  if (job.options.tell)
    job.options.tell(job.diagnostics);
  else
    std::fputs(job.diagnostics.format_all().c_str(), stderr);
}

std::vector<std::string> warnings_of(const deck::Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const deck::Diagnostic& diagnostic : diagnostics.all())
    if (diagnostic.severity == deck::Severity::warning)
      result.push_back(fmt::format("{}:{}:{}: {}: {}", diagnostics.file(),
                                   diagnostic.where.line, diagnostic.where.column,
                                   diagnostic.card, diagnostic.message));
  return result;
}

}  // namespace

int run_deck(const RunOptions& options) {
  Job job(options);
  for (const char* ending : {".out", ".vtkhdf", ".ckpt.h5", ".summary.json"}) {
    std::error_code absent;
    if (std::filesystem::equivalent(options.deck, job.name + ending, absent)) {
      fmt::print(stderr,
                 "blocks: error: the run would overwrite its deck {}\n  hint: choose "
                 "another name with -o NAME\n",
                 options.deck);
      return usage_error;
    }
  }
  Model checked;
  std::vector<std::string> notes;
  catch_interrupts();
  std::optional<EndAtOnce> at_once;
  if (options.ends_process)
    at_once.emplace(nothing_written, interrupted);
  const bool sound = check(job, checked, notes);
  tell(job);
  if (!sound)
    return job.fault;
  if (options.verbose) {
    std::fputs(check_report(job.diagnostics.file(), checked, job.certificate).c_str(),
               stderr);
    for (const std::string& note : notes)
      std::fputs((note + '\n').c_str(), stderr);
  }
  if (options.until && job.loads() && checked.time >= *options.until) {
    fmt::print(stderr,
               "blocks: error: --until {} is not later than the time of {}, {:g}\n",
               *options.until, job.checkpoint(), checked.time);
    return usage_error;
  }
  if (options.at_start && !job.loads())
    options.at_start(checked, job.certificate);
  checked = {};  // frees the memory before the run
  at_once.reset();
  Console console(!options.json, options.quiet);
  console.give_warnings_to(options.warn);
  return execute(job, console, warnings_of(job.diagnostics));
}

namespace {

CheckedDeck checked_deck(Job& job) {
  CheckedDeck checked;
  checked.file = job.diagnostics.file();
  const bool sound = check(job, checked.model, checked.notes);
  tell(job);
  checked.code = sound ? done : job.fault;
  checked.certificate = job.certificate;
  if (sound && checked.model.blocks.count_present() > 0)
    checked.time_step = dynamics::choose_time_step(checked.model).dt;
  return checked;
}

}  // namespace

CheckedDeck build_checked(const RunOptions& options) {
  Job job(options);
  return checked_deck(job);
}

int check_deck(const RunOptions& options) {
  Job job(options);
  catch_interrupts();
  const EndAtOnce at_once(nothing_written, interrupted);
  const auto checked = checked_deck(job);
  if (checked.code != done)
    return checked.code;
  if (!options.quiet) {
    auto certificate = checked.certificate;
    if (certificate && certificate->blocks < checked.model.blocks.size()) {
      // A resumed run proves new blocks when it moves them.
      certificate = std::make_shared<const AssemblyCertificate>(
          certify_assembly(checked.model.blocks, certificate->moved, *certificate));
    }
    fmt::print("{}", check_report(checked.file, checked.model, certificate));
    for (const std::string& note : checked.notes)
      fmt::print("{}\n", note);
  }
  return done;
}

}  // namespace blocks::run
