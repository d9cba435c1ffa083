// When a run stops for want of time, and the states that it keeps: checkpoints, those
// of SAVE, and the last good state in memory.
#include <algorithm>

#include "run/executor/executor.hpp"
#include "run/support/interrupt.hpp"

namespace blocks::run {

namespace {

double seconds_since(std::chrono::steady_clock::time_point moment) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - moment)
      .count();
}

}  // namespace

bool Executor::time_is_up() const {
  return options_.time_limit > 0.0 && seconds_since(started_) >= options_.time_limit;
}

bool Executor::is_checkpoint_due() const {
  return seconds_since(saved_) >= options_.checkpoint_every;
}

/// A copy of a larger model would need too much memory; a checkpoint is written first
/// instead.
bool Executor::keeps_good_states() const {
  constexpr int max_new_blocks = 100'000;
  return model_.blocks.size() <= max_new_blocks;
}

/// The factor 50 limits the cost of good states to a fiftieth of the time.
bool Executor::is_good_state_due(double seconds) const {
  return keeps_good_states() && (!good_ || seconds_since(good_->kept) >=
                                               std::max(seconds, 50.0 * good_->took));
}

void Executor::keep_good_state() {
  const dynamics::Profile::Timer timer(profile(), dynamics::Profile::output);
  const Clock::time_point began = Clock::now();
  const output::Progress now = files_.here(progress());
  good_ = GoodState{stepper_.complete(), now, Clock::now(), seconds_since(began)};
}

long Executor::save_good_state() {
  if (!good_)
    return -1;
  files_.good_checkpoint(good_->model, good_->progress);
  return good_->model.steps;
}

void Executor::save(const std::string& path) {
  output::Progress now = progress();
  ++now.card;  // a restart goes on behind the card
  if (const std::string aside = files_.save(path, model_, now); !aside.empty())
    warn(aside);
}

Outcome Executor::stop_if_due() {
  if (interrupt_requested())
    return Outcome::interrupted;
  if (steps_made_ == options_.stop_after)
    return Outcome::step_limit;
  if (time_is_up())
    return Outcome::time_limit;
  if (is_good_state_due(between_good_states))
    keep_good_state();
  if (is_checkpoint_due())
    save_checkpoint();
  return Outcome::finished;
}

void Executor::save_checkpoint() {
  const dynamics::Profile::Timer timer(profile(), dynamics::Profile::output);
  files_.checkpoint(stepper_.complete(), progress());
  saved_ = Clock::now();
  saved_once_ = true;
  good_.reset();  // it is older than the checkpoint
}

}  // namespace blocks::run
