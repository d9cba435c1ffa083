#include "library/simulation_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "dynamics/cracks/cracking.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "dynamics/preparation/mass_scaling.hpp"
#include "geometry/numeric_environment.hpp"
#include "library/deck_messages.hpp"
#include "output/checkpoint/checkpoint.hpp"
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

void stop_at_errors(const deck::Diagnostics& diagnostics) {
  if (diagnostics.has_errors())
    throw DeckError(diagnostics.format_all(), library::messages_of(diagnostics));
}

void apply(run::Builder& builder, const deck::Command& command,
           deck::Diagnostics& diagnostics) {
  builder.apply(command);
  if (std::holds_alternative<deck::Save>(command.card))
    diagnostics.warning(command.where, command.name, "has no effect in a program",
                        "write_checkpoint() writes a checkpoint");
}

bool has_more_blocks(const Model& model, int before) {
  return model.blocks.size() > before && model.blocks.count_present() > 0;
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
  deck::Diagnostics diagnostics(name, text);
  deck::Deck parsed = deck::parse(name, text, diagnostics);
  run::read_outline_files(parsed, folder, diagnostics);
  if (motions == Motions::left_out)
    parsed.commands.erase(
        std::find_if(parsed.commands.begin(), parsed.commands.end(), deck::passes_time),
        parsed.commands.end());
  execute(parsed, diagnostics);
}

void Simulation::State::keep_warnings(const deck::Diagnostics& diagnostics) {
  for (const deck::Diagnostic& diagnostic : diagnostics.all()) {
    std::string line = diagnostics.format(diagnostic);
    if (diagnostic.severity == deck::Severity::warning &&
        std::find(warnings.begin(), warnings.end(), line) == warnings.end())
      warnings.push_back(std::move(line));
  }
}

void Simulation::State::execute(const deck::Deck& deck,
                                deck::Diagnostics& diagnostics) {
  ++changes;
  // The cards first act on a copy in which no time passes. All errors are thus found
  // before the model changes.
  Model trial = current();
  std::optional<Beginning> beginning = check(trial, deck, diagnostics);
  const bool adds_blocks = trial.blocks.size() != model.blocks.size() ||
                           trial.blocks.corners() != model.blocks.corners();
  if (adds_blocks && hooks.before_new_blocks)
    hooks.before_new_blocks();
  take(beginning ? std::move(beginning->model) : std::move(trial));
  if (beginning) {
    trial = {};
    play(deck, *std::move(beginning), {diagnostics.file(), deck.text});
  }
  if (model.blocks.count_present() > 0)
    prepare(model);
  half_depth_ = run::half_depth(model.blocks);
}

/// Without new blocks the columns keep their memory.
void Simulation::State::take(Model&& other) {
  Blocks blocks = std::move(model.blocks);
  blocks = other.blocks;
  model = std::move(other);
  model.blocks = std::move(blocks);
}

/// Prepares the model for steps and records a warning for each block outside the
/// domain.
void Simulation::State::prepare(Model& on) {
  dynamics::prepare(on);
  stepper.changed();
  for (std::string& warning : watch_.check_step(on, {}))
    warnings.push_back(std::move(warning));
}

/// Loads the checkpoint of a RESTART card into a model.
void Simulation::State::load(Model& into, const deck::Command& command,
                             deck::Diagnostics& diagnostics) {
  const auto& card = std::get<deck::Restart>(command.card);
  if (!card.file.given) {
    diagnostics.error(command.where, "RESTART", "the name of the checkpoint is missing",
                      "write RESTART, file");
    stop_at_errors(diagnostics);
  }
  output::CheckpointInfo from;
  into =
      output::read_checkpoint(run::checkpoint_named(folder, card.file.value, ""), from);
  dynamics::end_mass_scaling(into);  // of a SOLVE that was not finished
  overlaps = from.progress.overlaps;
  watch_ = run::MotionWatch(into,
                            {from.progress.fast_reported, from.progress.flight_reported,
                             from.progress.deep_reported});
  crack_watch_ = run::CrackWatch(into);
}

std::optional<Simulation::State::Beginning>
Simulation::State::check(Model& trial, const deck::Deck& deck,
                         deck::Diagnostics& diagnostics) {
  const std::vector<deck::Command>& cards = deck.commands;
  if (!cards.empty() && std::holds_alternative<deck::Restart>(cards.front().card))
    load(trial, cards.front(), diagnostics);
  const int judged = trial.blocks.size();
  run::Builder builder(
      trial, diagnostics,
      {trial, cards, {.folder = folder, .unread = deck.unread, .overlaps = overlaps}});
  std::optional<Beginning> beginning;
  for (std::size_t i = 0; i < cards.size(); ++i) {
    apply(builder, cards[i], diagnostics);
    if (!deck::passes_time(cards[i]))
      continue;
    if (!diagnostics.has_errors())
      builder.check_before_motion(cards[i], !beginning);
    if (!beginning && !diagnostics.has_errors())
      beginning = Beginning{i, trial, builder.state(), judged};
  }
  if (!beginning && !diagnostics.has_errors() && has_more_blocks(trial, judged))
    builder.check_before_motion(one_step(cards), true);
  end_cards(builder, diagnostics);
  return beginning;
}

/// Goes on with the first card with which time passes.
void Simulation::State::play(const deck::Deck& deck, Beginning beginning,
                             deck::Diagnostics diagnostics) {
  run::Builder builder(model, diagnostics, std::move(beginning.builder));
  builder.begin_to_move();
  for (std::size_t i = beginning.card; i < deck.commands.size(); ++i) {
    const deck::Command& command = deck.commands[i];
    if (i > beginning.card) {
      apply(builder, command, diagnostics);
      if (!deck::passes_time(command))
        continue;
      builder.check_before_motion(command, true);
      stop_at_errors(diagnostics);
    }
    make_steps(command);
  }
  if (!diagnostics.has_errors() && has_more_blocks(model, beginning.judged))
    builder.check_before_motion(one_step(deck.commands), true);
  end_cards(builder, diagnostics);
}

/// Makes the steps of a card with which time passes.
void Simulation::State::make_steps(const deck::Command& command) {
  prepare(model);
  half_depth_ = run::half_depth(model.blocks);
  if (const auto* motion = std::get_if<deck::Motion>(&command.card))
    step(run::steps_for(motion->dt.value, model.time_step.dt), true);
  else if (const auto* cycle = std::get_if<deck::Cycle>(&command.card))
    step(cycle->ncycle.value, true);
  else if (const auto* solving = std::get_if<deck::Solve>(&command.card))
    solve(*solving, command.where.line);
  else
    factor_of_safety(std::get<deck::Fos>(command.card), command.where.line);
  stepper.up_to_date();  // cards may follow
}

/// Throws DeckError if there were errors. Otherwise keeps what the cards have told.
void Simulation::State::end_cards(const run::Builder& builder,
                                  const deck::Diagnostics& diagnostics) {
  stop_at_errors(diagnostics);
  if (const auto& certificate = builder.certificate())
    overlaps = certificate->overlaps;
  keep_warnings(diagnostics);
}

void Simulation::State::make_step(bool reads) {
  contacts_known = reads;
  const dynamics::StepResult moved =
      stepper.advance(reads, model.settings.normal_stiffness * half_depth_);
  for (std::string& warning : watch_.check_step(model, moved))
    warnings.push_back(std::move(warning));
  if (watch_.is_state_check_due(model))
    for (std::string& warning : watch_.check_state(stepper.up_to_date()))
      warnings.push_back(std::move(warning));
  if (run::may_be_unsound(model.settings, moved, half_depth_)) {
    unsound = run::unsound(stepper.up_to_date(), moved, half_depth_);
    if (!unsound.empty())
      throw UnsoundRun(unsound);
  }
  if (dynamics::may_crack(model.settings)) {
    if (stepper.crack() > 0)
      half_depth_ = run::half_depth(model.blocks);
    for (std::string& warning : crack_watch_.take_news(model).warnings)
      warnings.push_back(std::move(warning));
  }
  if (hooks.after_step)
    hooks.after_step();
}

void Simulation::State::step(long count, bool reads) {
  for (long i = 1; i <= count; ++i)
    make_step(reads && i == count);
}

void Simulation::State::solve(const deck::Solve& card, int line) {
  run::Convergence convergence(card);
  if (dynamics::may_scale_masses(model)) {
    dynamics::begin_mass_scaling(model);
    stepper.changed();
  }
  while (!convergence.is_finished()) {
    const bool tested = convergence.is_due();
    make_step(tested);
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
