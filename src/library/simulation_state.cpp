#include "library/simulation_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "dynamics/cracks/cracking.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "dynamics/mass_scaling.hpp"
#include "geometry/numeric_environment.hpp"
#include "library/deck_messages.hpp"
#include "output/checkpoint.hpp"
#include "run/builder/builder.hpp"
#include "run/cutting/joint_files.hpp"
#include "run/executor/executor.hpp"
#include "run/executor/saved_state.hpp"
#include "run/safety/safety_report.hpp"
#include "run/safety/safety_search.hpp"
#include "run/support/deck_file.hpp"
#include "run/watch/convergence.hpp"
#include "run/watch/soundness.hpp"

namespace blocks {
namespace {

/// A CYCLE command of one step at the position of the last card that made blocks. The
/// checks before a motion are applied to it, because the caller will make the steps.
deck::Command one_step(const std::vector<deck::Command>& cards) {
  const auto makes_blocks = [](const deck::Command& command) {
    return std::holds_alternative<deck::Create>(command.card) ||
           std::holds_alternative<deck::Layer>(command.card) ||
           std::holds_alternative<deck::Read9>(command.card);
  };
  const auto maker = std::find_if(cards.rbegin(), cards.rend(), makes_blocks);
  const deck::Command& last = maker == cards.rend() ? cards.back() : *maker;
  return {last.where, last.name, deck::Cycle{{1, last.where}}};
}

int checked(int threads) {
  if (threads < 1 || threads > 1024)
    throw std::invalid_argument(
        fmt::format("{} threads are not in range 1 to 1024", threads));
  return threads;
}

}  // namespace

Simulation::State::State(std::string deck_name, std::string deck_folder,
                         std::string deck, int threads, Motions motions,
                         library::Hooks given_hooks)
    : hooks(std::move(given_hooks)), name(std::move(deck_name)),
      folder(std::move(deck_folder)), text(std::move(deck)), work(checked(threads)) {
  stepper.before_split = hooks.before_new_blocks;
  if (const std::string fault = geometry::check_numeric_environment(); !fault.empty())
    throw std::runtime_error(fault);
  dynamics::kernels();
  deck::Diagnostics said(name, text);
  deck::Deck parsed = deck::parse(name, text, said);
  run::read_outline_files(parsed, folder, said);
  if (motions == Motions::left_out)
    parsed.commands.erase(
        std::find_if(parsed.commands.begin(), parsed.commands.end(), deck::passes_time),
        parsed.commands.end());
  execute(parsed, said);
}

void Simulation::State::keep_warnings(const deck::Diagnostics& said) {
  for (const deck::Diagnostic& diagnostic : said.all()) {
    std::string line = said.format(diagnostic);
    if (diagnostic.severity == deck::Severity::warning &&
        std::find(warnings.begin(), warnings.end(), line) == warnings.end())
      warnings.push_back(std::move(line));
  }
}

void Simulation::State::execute(const deck::Deck& deck, deck::Diagnostics& said) {
  ++changes;
  // The cards are first executed on a copy in which no time passes. All errors are thus
  // found before the model changes.
  Model trial = current();
  execute_on(trial, deck, said, false);
  keep_warnings(said);
  const bool adds_blocks = trial.blocks.size() != model.blocks.size() ||
                           trial.blocks.corners() != model.blocks.corners();
  if (adds_blocks && hooks.before_new_blocks)
    hooks.before_new_blocks();
  if (std::any_of(deck.commands.begin(), deck.commands.end(), deck::passes_time)) {
    deck::Diagnostics later(said.file(), deck.text);
    execute_on(model, deck, later, true);
    keep_warnings(later);
  } else {
    // Without new blocks the columns keep their memory.
    Blocks blocks = std::move(model.blocks);
    blocks = trial.blocks;
    model = std::move(trial);
    model.blocks = std::move(blocks);
  }
  if (model.blocks.count_present() > 0)
    prepare(model);
  half_depth_ = run::half_depth(model.blocks);
}

/// Prepares the model for steps and records a warning for each block outside the
/// domain.
void Simulation::State::prepare(Model& on) {
  dynamics::prepare(on);
  stepper.changed();
  for (std::string& told : watch_.after(on, {}))
    warnings.push_back(std::move(told));
}

/// Executes the cards on a model and throws DeckError after the last card if there were
/// errors. If `moving` is false, MOTION, CYCLE and SOLVE are checked, but no time
/// passes.
void Simulation::State::execute_on(Model& on, const deck::Deck& deck,
                                   deck::Diagnostics& said, bool moving) {
  const auto stop_at_faults = [&] {
    if (said.has_errors())
      throw DeckError(said.format_all(), library::messages_of(said));
  };
  if (!deck.commands.empty())
    if (const auto* card = std::get_if<deck::Restart>(&deck.commands.front().card)) {
      if (!card->file.given) {
        said.error(deck.commands.front().where, "RESTART",
                   "the name of the checkpoint is missing", "write RESTART, file");
        stop_at_faults();
      }
      output::CheckpointInfo from;
      on = output::read_checkpoint(run::checkpoint_named(folder, card->file.value, ""),
                                   from);
      dynamics::end_mass_scaling(on);  // of a SOLVE that was not finished
      overlaps = from.progress.overlaps;
      watch_ = run::MotionWatch(on, {from.progress.fast_told, from.progress.flight_told,
                                     from.progress.deep_told});
      crack_watch_ = run::CrackWatch(on);
    }
  const int judged = on.blocks.size();
  run::Builder builder(on, said, deck.commands,
                       {.seed = {},
                        .tape9 = "tape9",
                        .folder = folder,
                        .unread = deck.unread,
                        .overlaps = overlaps,
                        .moves = moving});
  bool in_place = true;
  for (const deck::Command& command : deck.commands) {
    builder.apply(command);
    if (std::holds_alternative<deck::Save>(command.card))
      said.warning(command.where, command.name, "has no effect in a program",
                   "write_checkpoint() writes a checkpoint");
    if (!deck::passes_time(command))
      continue;
    if (moving || !said.has_errors())
      builder.check_before_motion(command, in_place);
    in_place = moving;
    if (!moving)
      continue;
    stop_at_faults();
    prepare(on);
    half_depth_ = run::half_depth(on.blocks);
    if (const auto* motion = std::get_if<deck::Motion>(&command.card))
      step(run::steps_for(motion->dt.value, on.time_step.dt), true);
    else if (const auto* cycle = std::get_if<deck::Cycle>(&command.card))
      step(cycle->ncycle.value, true);
    else if (const auto* solving = std::get_if<deck::Solve>(&command.card))
      solve(*solving, command.where.line);
    else
      factor_of_safety(std::get<deck::Fos>(command.card), command.where.line);
  }
  if (in_place && !said.has_errors() && on.blocks.size() > judged &&
      on.blocks.count_present() > 0)
    builder.check_before_motion(one_step(deck.commands), true);
  stop_at_faults();
  if (const auto& certificate = builder.certificate())
    overlaps = certificate->overlaps;
}

void Simulation::State::advance(bool reads) {
  contacts_known = reads;
  const dynamics::StepResult moved =
      stepper.advance(reads, model.settings.normal_stiffness * half_depth_);
  for (std::string& told : watch_.after(model, moved))
    warnings.push_back(std::move(told));
  if (watch_.is_look_due(model))
    for (std::string& told : watch_.look(stepper.up_to_date()))
      warnings.push_back(std::move(told));
  if (run::may_be_unsound(model.settings, moved, half_depth_)) {
    unsound = run::unsound(stepper.up_to_date(), moved, half_depth_);
    if (!unsound.empty())
      throw UnsoundRun(unsound);
  }
  if (dynamics::may_crack(model.settings)) {
    if (stepper.crack() > 0)
      half_depth_ = run::half_depth(model.blocks);
    for (std::string& told : crack_watch_.after(model).warnings)
      warnings.push_back(std::move(told));
  }
  if (hooks.after_step)
    hooks.after_step();
}

void Simulation::State::step(long count, bool reads) {
  for (long i = 1; i <= count; ++i)
    advance(reads && i == count);
}

void Simulation::State::solve(const deck::Solve& card, int line) {
  run::Convergence convergence(card);
  if (dynamics::may_scale_masses(model)) {
    dynamics::begin_mass_scaling(model);
    stepper.changed();
  }
  while (!convergence.is_finished()) {
    const bool tested = convergence.is_due();
    advance(tested);
    convergence.after_step(tested ? stepper.up_to_date() : model);
  }
  model.solves.push_back(convergence.record(model, line));
  if (model.blocks.has_scaled_masses()) {
    dynamics::end_mass_scaling(model);
    stepper.changed();
  }
  if (const SolveRecord& solve = model.solves.back(); !solve.converged)
    warnings.push_back(run::solve_warning(solve, model.settings));
}

void Simulation::State::factor_of_safety(const deck::Fos& card, int line) {
  const int threads = work.workers->threads();
  const run::GiveUp never = [] { return false; };
  const run::GiveUp look_up = [this] {  // what the hook throws ends the search
    if (hooks.after_step)
      hooks.after_step();
    return false;
  };
  stepper.up_to_date();
  model.safety_factors.push_back(run::begin_search(card, line));
  const Model base = run::state_before_last(model);
  SafetyFactor& record = model.safety_factors.back();
  for (std::string& doubt :
       run::state_warnings(record, model.exits.size(), run::is_moving(model)))
    warnings.push_back(std::move(doubt));
  try {
    static_cast<void>(run::set_limits(record, base, card, threads, look_up));
    run::SafetySearch search(base, record, card.as_solve(), threads, threads, never);
    while (auto made = search.next(run::trials_of_last(model), hooks.after_step))
      run::record_trial(model, made->trial);
  } catch (...) {
    run::forget_last_search(model);
    throw;
  }
  record.complete = true;
  if (const std::string doubt = run::safety_warning(record, run::trials_of_last(model));
      !doubt.empty())
    warnings.push_back(doubt);
}

void Simulation::State::must_be_sound() const {
  if (!unsound.empty())
    throw UnsoundRun("cannot continue an unsound run: " + unsound);
}

void Simulation::State::must_be_read() const {
  if (!contacts_known)
    throw std::logic_error(fmt::format(
        "the contacts of step {} are not known, because it was not read", model.steps));
}

int Simulation::State::index(int block) const {
  const int count = model.blocks.size();
  if (block < 1 || block > count)
    throw std::out_of_range(
        count == 0
            ? fmt::format("there is no block {}, the model has no blocks", block)
            : fmt::format("there is no block {}, blocks are 1 to {}", block, count));
  return block - 1;
}

}  // namespace blocks
