// FOS: trials with reduced strength, their records and their files (docs/stability.md).
#include <fmt/format.h>

#include "run/executor/continuation_hint.hpp"
#include "run/executor/executor.hpp"
#include "run/safety/safety_report.hpp"
#include "run/safety/safety_search.hpp"
#include "run/support/interrupt.hpp"

namespace blocks::run {

Outcome Executor::factor_of_safety(const deck::Fos& card, int line) {
  begin_card();
  const int threads = work_.workers->threads();
  const GiveUp give_up = [this] { return interrupt_requested() || time_is_up(); };
  if (!begun_) {
    model_.safety_factors.push_back(begin_search(card, line));
    for (const std::string& doubt : state_warnings(
             model_.safety_factors.back(), model_.exits.size(), is_moving(model_)))
      warn(doubt);
    for (const TrialOutcome outcome : {TrialOutcome::stable, TrialOutcome::failing})
      if (const std::string aside = files_.move_state_aside(name_of_state(outcome));
          !aside.empty())
        warn(aside);
    progress_.steps_left = 1;  // the card is begun, whatever its trials need
  }
  const Model base = state_before_last(model_);
  SafetyFactor& record = model_.safety_factors.back();
  if (record.max_steps == 0 && !set_limits(record, base, card, threads, give_up)) {
    tell_trials_remain();
    return stop_if_due();
  }
  SafetySearch search(base, record, card.as_solve(), threads,
                      options_.trials_at_once > 0 ? options_.trials_at_once : threads,
                      give_up);
  while (true) {
    const std::vector<SafetyTrial> known = trials_of_last(model_);
    std::optional<TrialResult> made = search.next(known);
    if (!made)
      break;
    if (made->given_up) {
      tell_trials_remain();
      return stop_if_due();
    }
    record_trial(model_, made->trial);
    const std::string message = trial_line(made->trial);
    files_.message(message);
    console_.note(message);
    write_trial(base, *made);
    steps_made_ += made->trial.steps;
    save_checkpoint();
    if (options_.stop_after > 0 && steps_made_ >= options_.stop_after) {
      tell_trials_remain();
      return Outcome::step_limit;
    }
  }
  record.complete = true;
  progress_.steps_left = 0;
  end_card();
  const std::vector<SafetyTrial> trials = trials_of_last(model_);
  if (const std::string doubt = safety_warning(record, trials); !doubt.empty())
    warn(doubt);
  files_.message(safety_line(record, trials));
  console_.note(safety_line(record, trials));
  return Outcome::finished;
}

void Executor::tell_trials_remain() const {
  console_.note(
      fmt::format("trials of this card remain; to continue: {}",
                  continuation_command(options_, files_.checkpoint_path(), true)));
}

std::string Executor::name_of_state(TrialOutcome outcome) const {
  const std::size_t cards = model_.safety_factors.size();
  return describe(outcome) + (cards > 1 ? std::to_string(cards) : "");
}

void Executor::write_trial(const Model& base, const TrialResult& made) {
  const std::vector<SafetyTrial> trials = trials_of_last(model_);
  const SafetyBracket bracket = bracket_of(trials);
  const bool is_best = made.trial.outcome == TrialOutcome::stable
                           ? bracket.stable == made.trial.factor
                           : made.trial.outcome == TrialOutcome::failing &&
                                 bracket.failing == made.trial.factor;
  if (!is_best)
    return;
  output::Progress done = progress();
  ++done.card, done.steps_left = 0, done.finished = true;
  if (const std::string aside =
          files_.keep_state(name_of_state(made.trial.outcome), trial_line(made.trial),
                            base, made.state, done);
      !aside.empty())
    warn(aside);
}

}  // namespace blocks::run
