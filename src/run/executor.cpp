#include "run/executor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "run/interrupt.hpp"

namespace blocks::run {

long steps_for(double interval, double dt) {
  return static_cast<long>(std::ceil(interval / dt - 1e-9));
}

Executor::Executor(Model& model, RunFiles& files, Console& console,
                   const RunOptions& options)
    : model_(model), files_(files), console_(console), options_(options),
      exits_told_(model.exits.size()) {}

Outcome Executor::motion(double interval) {
  start();
  return advance(steps_for(interval, model_.time_step.dt));
}

Outcome Executor::cycle(long steps) {
  start();
  return advance(steps);
}

void Executor::start() {
  dynamics::prepare(model_);
  if (!echoed_) {
    files_.input_echo(model_);
    console_.note(fmt::format("dt {:.6g} set by block {} ({}), {} blocks, seed {}",
                              model_.time_step.dt, model_.time_step.block + 1,
                              model_.time_step.elastic ? "its stiffness" : "contact",
                              model_.blocks.size(), model_.settings.seed));
    files_.frame(model_);
    files_.table(model_);
  }
  echoed_ = true;
  watch({});
  console_.row(model_);
}

Outcome Executor::advance(long steps) {
  const long rows = 10, row_every = std::max(1L, (steps + rows - 1) / rows);
  for (long i = 1; i <= steps; ++i) {
    const dynamics::Displacement moved = dynamics::step(model_, buffers_);
    if (!moved.finite) {
      warn(
          fmt::format("at time {:g} (step {}) some position is no longer a number; the "
                      "time step is probably too large: lower FRACTION",
                      model_.time, model_.steps));
      return Outcome::unsound;
    }
    watch(moved);
    output_if_due();
    if (i % row_every == 0 || i == steps)
      console_.row(model_);
    if (i % 64 == 0 || interrupt_requested()) {
      console_.progress(model_, share_from_ + (share_to_ - share_from_) *
                                                  static_cast<double>(i) /
                                                  static_cast<double>(steps));
      if (const Outcome outcome = pressed_for_time(); outcome != Outcome::finished)
        return outcome;
    }
  }
  return Outcome::finished;
}

void Executor::output_if_due() {
  // Half a step of grace, so that round-off in the sums of dt loses no output.
  const double now = model_.time + 0.5 * model_.time_step.dt;
  const auto due = [&](OutputClock& clock) {
    if (!(clock.interval > 0.0) || now < clock.due)
      return false;
    const double missed = std::floor((now - clock.due) / clock.interval);
    clock.due += (missed + 1.0) * clock.interval;
    return true;
  };
  if (due(model_.plots)) {
    files_.frame(model_);
    worst_overlap_ = std::max(worst_overlap_, totals(model_).worst_overlap);
  }
  if (due(model_.output))
    files_.table(model_);
}

void Executor::watch(const dynamics::Displacement& moved) {
  if (moved.largest > model_.settings.contact_tolerance && !fast_told_) {
    fast_told_ = true;
    warn(fmt::format(
        "block {} moved a corner by {:.3g} in one step at time {:g}, more than "
        "ctol {:g}: contacts may be found late; lower FRACTION or raise ctol",
        moved.block + 1, moved.largest, model_.time,
        model_.settings.contact_tolerance));
  }
  for (; exits_told_ < model_.exits.size(); ++exits_told_) {
    const DomainExit& exit = model_.exits[exits_told_];
    warn(fmt::format(
        "block {} left the domain at time {:g} and is fixed where it stands",
        exit.block + 1, exit.time));
  }
}

void Executor::warn(const std::string& message) {
  console_.warn(message);
  files_.message("warning: " + message);
  warnings_.push_back(message);
}

Outcome Executor::pressed_for_time() {
  if (interrupt_requested())
    return Outcome::interrupted;
  const auto seconds = [](Clock::duration d) {
    return std::chrono::duration<double>(d).count();
  };
  const auto now = Clock::now();
  if (options_.time_limit > 0.0 && seconds(now - started_) >= options_.time_limit)
    return Outcome::time_limit;
  if (options_.checkpoint_every > 0.0 &&
      seconds(now - saved_) >= options_.checkpoint_every) {
    files_.checkpoint(model_);
    saved_ = Clock::now();
  }
  return Outcome::finished;
}

}  // namespace blocks::run
