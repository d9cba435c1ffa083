// The steps of a motion, and what is due before and after each of them.
#include "run/executor/executor.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "dynamics/cracks/cracking.hpp"
#include "run/support/interrupt.hpp"
#include "run/watch/soundness.hpp"

namespace blocks::run {

Outcome Executor::make_steps(long steps) {
  stepper_.changed();
  recorder_.begin(model_);
  const Outcome outcome = make_each_step(steps);
  stepper_.complete();
  if (progress_.steps_left == 0)
    model_.kept = {};  // the next motion decides all pairs again
  return outcome;
}

Outcome Executor::make_each_step(long steps) {
  const long last = std::min(steps, steps_to_end());
  progress_.steps_left = steps;
  changed_ = changed_ && last == 0;
  if (is_good_state_due(0.0))
    keep_good_state();
  else if (!keeps_good_states() && (good_ || !saved_once_))
    save_checkpoint();
  for (long i = 1; i <= last; ++i) {
    const StepPlan plan = plan_step(i, last);
    if (!make_step(plan))
      return Outcome::unsound;
    const bool ends = ends_card(steps - i);
    if (plan.row || ends || (plan.tested && solving_->has_new_decade()))
      console_.row(stepper_.up_to_date());
    ++steps_made_;
    progress_.steps_left = steps - i;
    if (ends)
      end_card();
    if (plan.pause || (plan.read && interrupt_requested())) {
      if (console_.is_progress_due())
        console_.progress(stepper_.up_to_date(), share_after(i, last),
                          solving_ ? solving_->balance() : Balance{});
      if (const Outcome outcome = stop_if_due(); outcome != Outcome::finished) {
        tell_what_remains();
        return outcome;
      }
    }
    if (ends)
      return Outcome::finished;
  }
  if (last == steps)
    return Outcome::finished;
  tell_what_remains();
  return Outcome::end_time;
}

Executor::StepPlan Executor::plan_step(long i, long last) const {
  const long rows = 10, row_every = std::max(1L, (last + rows - 1) / rows);
  StepPlan plan;
  plan.audited = audit_.is_due(model_);
  plan.row = i % row_every == 0 || i == last;
  const bool by_clock =
      i % 64 == 0 && (console_.is_progress_due() || time_is_up() ||
                      is_checkpoint_due() || is_good_state_due(between_good_states));
  plan.pause =
      by_clock || interrupt_requested() || steps_made_ + 1 == options_.stop_after;
  plan.sampled = is_sample_due();
  plan.tested = solving_ && solving_->is_due();
  plan.read = plan.audited || plan.row || plan.pause || plan.sampled || plan.tested ||
              is_output_due();
  return plan;
}

bool Executor::make_step(const StepPlan& plan) {
  if (plan.audited)
    audit_.keep_start(stepper_.up_to_date());
  const double limit = model_.settings.normal_stiffness * half_depth_;
  const dynamics::StepResult moved = stepper_.advance(plan.read, limit);
  if (may_be_unsound(model_.settings, moved, half_depth_)) {
    if (const std::string fault = unsound(stepper_.up_to_date(), moved, half_depth_);
        !fault.empty()) {
      warn(fault);
      return false;
    }
  }
  if (plan.audited && !passes_audit())
    return false;
  warn_of_motion(moved);
  if (dynamics::may_crack(model_.settings))
    split_blocks();
  if (plan.sampled)
    recorder_.record(stepper_.up_to_date());
  if (plan.read)
    write_due_output();
  if (solving_) {
    const dynamics::Profile::Timer timer(work_.profile, dynamics::Profile::output);
    solving_->after_step(plan.tested ? stepper_.up_to_date() : model_);
    progress_.below_ratio = solving_->is_below();
  }
  return true;
}

namespace {

/// Output is due up to half a step early, so that round-off in the sums of dt loses no
/// output.
bool is_due(const OutputClock& clock, double time, double dt) {
  return clock.interval > 0.0 && time + 0.5 * dt >= clock.due;
}
/// Whether this step is the one nearest to one of the times.
bool is_nearest(const std::vector<double>& times, double time, double dt) {
  const auto next = std::upper_bound(times.begin(), times.end(), time - 0.5 * dt);
  return next != times.end() && *next <= time + 0.5 * dt;
}
void wind(OutputClock& clock, double time, double dt) {
  const double now = time + 0.5 * dt;
  const double missed = std::floor((now - clock.due) / clock.interval);
  const double next = clock.due + (missed + 1.0) * clock.interval;
  clock.due = std::isfinite(next) ? next : now;  // if the interval is far below dt
}

}  // namespace

bool Executor::is_output_due() const {
  const double then = dynamics::time_after_step(model_), dt = model_.time_step.dt;
  return is_due(model_.plots, then, dt) || is_due(model_.output, then, dt) ||
         is_nearest(model_.plot_times, then, dt) ||
         model_.plot_steps.is_due(model_.steps + 1);
}

bool Executor::is_sample_due() const {
  constexpr double rounding = 1e-6;  // of a step, for the sum of times
  return recorder_.is_due(dynamics::time_after_step(model_) +
                          (1.0 + rounding) * model_.time_step.dt);
}

void Executor::write_due_output() {
  const dynamics::Profile::Timer timer(work_.profile, dynamics::Profile::output);
  const auto due = [&](OutputClock& clock) {
    const bool is = is_due(clock, model_.time, model_.time_step.dt);
    if (is)
      wind(clock, model_.time, model_.time_step.dt);
    return is;
  };
  const bool at_interval = due(model_.plots);
  if (at_interval || model_.plot_steps.is_due(model_.steps) ||
      is_nearest(model_.plot_times, model_.time, model_.time_step.dt))
    files_.frame(stepper_.up_to_date());
  if (due(model_.output))
    files_.table(stepper_.up_to_date());
}

void Executor::warn_of_motion(const dynamics::StepResult& moved) {
  for (const std::string& message : watch_.check_step(model_, moved))
    warn(message);
  if (watch_.is_state_check_due(model_))
    for (const std::string& message : watch_.check_state(stepper_.up_to_date()))
      warn(message);
}

void Executor::split_blocks() {
  if (stepper_.crack() > 0)
    half_depth_ = half_depth(model_.blocks);
  const CrackNews news = crack_watch_.take_news(model_);
  for (const std::string& line : news.cracks)
    files_.message(line);
  for (const std::string& line : news.warnings)
    warn(line);
}

/// Reports what the audit of the last step found. Returns false if a decision was wrong
/// or the list misses a pair.
bool Executor::passes_audit() {
  const AuditWatch::Verdict verdict =
      audit_.audit_step(stepper_.complete(), stepper_.listed_pairs());
  for (const auto* lines : {&verdict.overlaps, &verdict.deep})
    for (const std::string& line : *lines)
      files_.message(line);
  for (const std::string& line : verdict.faults)
    warn(line);
  for (const std::string& line : verdict.stories) {
    console_.warn(line);
    files_.message(line);
  }
  return verdict.faults.empty();
}

}  // namespace blocks::run
