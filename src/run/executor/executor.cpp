#include "run/executor/executor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <thread>

#include "dynamics/cracks/cracking.hpp"
#include "dynamics/preparation/mass_scaling.hpp"
#include "model/words/law_report.hpp"
#include "model/words/time_step_text.hpp"
#include "run/executor/continuation_hint.hpp"
#include "run/reports/profile_table.hpp"
#include "run/support/interrupt.hpp"
#include "run/watch/soundness.hpp"
#include "text/counted.hpp"

namespace blocks::run {

namespace {

int threads_of(const RunOptions& options) {
  return options.threads > 0
             ? options.threads
             : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

long steps_for(double interval, double dt) {
  return static_cast<long>(std::ceil(interval / dt - 1e-9));
}

Executor::Executor(Model& model, RunFiles& files, Console& console,
                   const RunOptions& options)
    : model_(model), files_(files), console_(console), options_(options),
      work_(threads_of(options)), stepper_(model, work_), audit_(options.audit_every),
      watch_(model), recorder_(files.results()) {
  if (!options.profile)
    return;
  work_.profile = &profile_;
  work_.workers->measure(&profile_.in_workers);
}

void Executor::resume(const output::Progress& progress) {
  progress_ = progress;
  begun_ = progress.steps_left > 0;
  half_depth_ = progress.half_depth;
  watch_ = MotionWatch(model_, {progress.fast_reported, progress.flight_reported,
                                progress.deep_reported});
  crack_watch_ = CrackWatch(model_);
  // SAVE may have written the checkpoint before the first motion.
  echoed_ = started_moving_ = model_.started || progress.finished;
  std::istringstream lines(progress.warnings);
  for (std::string line; std::getline(lines, line);)
    warnings_.push_back(line);
}

void Executor::set_card(long index) {
  progress_.card = index;
  if (!begun_)
    progress_.steps_left = 0;
}

output::Progress Executor::progress() const {
  output::Progress now = progress_;
  now.half_depth = half_depth_;
  now.fast_reported = watch_.reported().fast;
  now.flight_reported = watch_.reported().flight;
  now.deep_reported = watch_.reported().deep;
  now.warnings.clear();
  for (const std::string& warning : warnings_)
    now.warnings += warning + '\n';
  return now;
}

Outcome Executor::motion(double interval) {
  begin_card();
  return make_steps(steps_left(steps_for(interval, model_.time_step.dt)));
}

long Executor::steps_to_end() const {
  if (!options_.until)
    return std::numeric_limits<long>::max();
  const double left = *options_.until - model_.time;
  return left > 0.0 ? steps_for(left, model_.time_step.dt) : 0;
}

Outcome Executor::cycle(long steps) {
  begin_card();
  return make_steps(steps_left(steps));
}

Outcome Executor::solve(const deck::Solve& card, int line) {
  begin_card();
  if (!begun_ && dynamics::may_scale_masses(model_))
    scale_masses();
  const long left = steps_left(card.nmax.value);
  solving_.emplace(card, card.nmax.value - left, begun_ && progress_.below_ratio);
  solve_line_ = line;
  const Outcome outcome = make_steps(left);
  solving_.reset();
  return outcome;
}

void Executor::scale_masses() {
  const double dt = model_.time_step.dt;
  dynamics::begin_mass_scaling(model_);
  const dynamics::MassFactors factors = dynamics::mass_factors(model_.blocks);
  const std::string line = fmt::format(
      "SOLVE scales masses by {:.3g} to {:.3g}: dt {:.6g} instead of {:.6g}",
      factors.min, factors.largest, model_.time_step.dt, dt);
  files_.message(line);
  console_.note(line);
}

bool Executor::ends_card(long left) const {
  return left == 0 || (solving_ && solving_->is_finished());
}

void Executor::end_card() {
  ++progress_.card;
  progress_.steps_left = 0;
  progress_.below_ratio = false;
  begun_ = false;
  if (!solving_)
    return;
  const Model& model = stepper_.up_to_date();
  const SolveRecord solve = solving_->record(model, solve_line_);
  model_.solves.push_back(solve);
  dynamics::end_mass_scaling(model_);
  {
    const dynamics::Profile::Timer timer(work_.profile, dynamics::Profile::output);
    files_.frame(model_);
  }
  if (!solve.converged)
    return warn(solve_warning(solve, model_.settings));
  files_.message(solve_line(solve));
  console_.note(solve_line(solve));
}

double Executor::share_after(long made, long last) const {
  const double of_card = solving_
                             ? solving_->share()
                             : static_cast<double>(made) / static_cast<double>(last);
  return share_from_ + (share_to_ - share_from_) * of_card;
}

void Executor::echo_input() {
  if (!echoed_)
    files_.input_echo(model_);
  echoed_ = true;
}

void Executor::finish() {
  echo_input();
  if (!model_.settings.joint_laws.empty())
    console_.note(bonds_line(model_));
  if (dynamics::may_crack(model_.settings))
    console_.note(cracks_line(model_));
  if (audit_.totals().every > 0)
    console_.note(audit_.summary());
}

void Executor::dump() {
  echo_input();
  files_.dump(model_);
}

void Executor::begin_card() {
  if (begun_) {  // resumed between two steps
    console_.row(model_);
    return;
  }
  const bool in_order = !model_.order.empty();
  const double old_dt = model_.time_step.dt;
  dynamics::prepare(model_);
  if (!started_moving_) {
    crack_watch_ = CrackWatch(model_);
    echo_input();
    console_.note(fmt::format(
        "dt {:.6g} set by block {} ({}), {}, seed {}", model_.time_step.dt,
        model_.time_step.block + 1, limit_in_words(model_.time_step, model_.settings),
        counted(model_.blocks.count_present(), "block"), model_.settings.seed));
    const dynamics::Profile::Timer timer(profile(), dynamics::Profile::output);
    files_.frame(model_);
    files_.table(model_);
  }
  if (started_moving_ && model_.time_step.dt != old_dt)
    console_.note(fmt::format("dt {:.6g} from now on, set by block {} ({})",
                              model_.time_step.dt, model_.time_step.block + 1,
                              limit_in_words(model_.time_step, model_.settings)));
  if (!in_order && !model_.order.empty())
    console_.note(
        "blocks are renumbered internally for memory locality; output is unaffected");
  started_moving_ = true;
  half_depth_ = half_depth(model_.blocks);
  warn_of_motion({});
  console_.row(model_);
}

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

void Executor::tell_profile() {
  if (work_.profile == nullptr)
    return;
  const double whole = std::chrono::duration<double>(Clock::now() - started_).count();
  console_.clear_progress();
  for (const std::string& line :
       profile_table(profile_, whole, steps_made_, model_, work_.workers->threads()))
    console_.note(line);
}

void Executor::tell_what_remains() const {
  const bool is_reached = steps_to_end() == 0;
  console_.note(fmt::format(
      "{}{} of this card remain{}; to continue: {}", solving_ ? "at most " : "",
      counted(progress_.steps_left, "step"), progress_.steps_left == 1 ? "s" : "",
      continuation_command(options_, files_.checkpoint_path(), !is_reached)));
}

void Executor::warn(const std::string& message) {
  console_.warn(message);
  remember(message);
}

void Executor::remember(const std::string& message) {
  files_.message("warning: " + message);
  warnings_.push_back(message);
}

}  // namespace blocks::run
