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
