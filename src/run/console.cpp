#include "run/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace blocks::run {
namespace {

std::string duration(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  if (s < 60)
    return fmt::format("{} s", s);
  if (s < 3600)
    return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

/// Prints without throwing. A full disk behind a log must not end the run, as an
/// exception of fmt::print would.
template <class... Values>
void say(std::FILE* stream, fmt::format_string<Values...> text, Values&&... values) {
  std::fputs(fmt::format(text, std::forward<Values>(values)...).c_str(), stream);
}

}  // namespace

Console::Console(bool table, bool quiet)
    : table_(table && !quiet), quiet_(quiet),
      terminal_(!quiet && isatty(STDERR_FILENO)) {}

void Console::row(const Model& model) {
  if (!table_ || model.steps == last_step_)
    return;
  last_step_ = model.steps;
  clear_progress();
  if (!header_shown_)
    say(stdout, "{:>10} {:>12} {:>12} {:>14} {:>14} {:>9} {:>9}\n", "step", "time",
        "dt", "kinetic energy", "worst overlap", "contacts", "searches");
  header_shown_ = true;
  const ModelTotals sum = totals(model);
  say(stdout, "{:>10} {:>12.6g} {:>12.5g} {:>14.6g} {:>14.6g} {:>9} {:>9}\n",
      model.steps, model.time, model.time_step.dt, sum.kinetic_energy,
      sum.worst_overlap, sum.active_contacts, model.search.updates);
  std::fflush(stdout);
}

void Console::warn(const std::string& message) {
  clear_progress();
  say(stderr, "warning: {}\n", message);
}

void Console::note(const std::string& message) {
  if (quiet_)
    return;
  clear_progress();
  say(stderr, "{}\n", message);
}

bool Console::progress_due() const {
  return terminal_ && Clock::now() - drawn_ >= std::chrono::milliseconds(100);
}

void Console::progress(const Model& model, double share) {
  const auto now = Clock::now();
  drawn_ = now;
  line_shown_ = true;
  const double spent = std::chrono::duration<double>(now - start_).count();
  const int width = 24, filled = static_cast<int>(share * width);
  const std::string remaining =
      share > 0.0 ? duration(spent * (1.0 - share) / share) + " left" : "";
  const ModelTotals sum = totals(model);
  say(stderr, "\r\033[K[{:#<{}}{:.<{}}] step {} t {:.4g} Ek {:.3g} contacts {} {}", "",
      filled, "", width - filled, model.steps, model.time, sum.kinetic_energy,
      sum.active_contacts, remaining);
  std::fflush(stderr);
}

void Console::clear_progress() {
  if (line_shown_)
    say(stderr, "\r\033[K");
  line_shown_ = false;
}

}  // namespace blocks::run
