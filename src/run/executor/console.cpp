#include "run/executor/console.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "model/local_ratio.hpp"

namespace blocks::run {
namespace {

/// Prints without throwing. A full disk behind a log must not end the run, as an
/// exception of fmt::print would.
template <class... Values>
void say(std::FILE* stream, fmt::format_string<Values...> text, Values&&... values) {
  std::fputs(fmt::format(text, std::forward<Values>(values)...).c_str(), stream);
}

/// Returns the width of the terminal at this moment; 80 if it is unknown.
int terminal_width() {
  constexpr int usual = 80;
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : usual;
}

/// Returns the columns of the ratios.
std::string ratios_of(const Model& model) {
  const Balance balance = balance_of(model);
  return fmt::format(" {:>9.2e} {:>9.2e} {:>8}", balance.ratio, balance.local,
                     balance.block < 0 ? "-" : fmt::format("{}", balance.block + 1));
}

}  // namespace

Console::Console(bool table, bool quiet, std::chrono::seconds between_log_lines)
    : table_(table && !quiet), quiet_(quiet), terminal_(isatty(STDERR_FILENO)),
      between_log_lines_(between_log_lines) {}

void Console::row(const Model& model) {
  if (!table_ || model.steps == last_step_)
    return;
  last_step_ = model.steps;
  clear_progress();
  if (!header_shown_)
    say(stdout, "{:>10} {:>12} {:>12} {:>14} {:>14} {:>9} {:>9}{}\n", "step", "time",
        "dt", "kinetic energy", "worst overlap", "contacts", "searches",
        ratio_shown_ ? fmt::format(" {:>9} {:>9} {:>8}", "ratio", "local", "of block")
                     : "");
  header_shown_ = true;
  const ModelTotals sum = totals(model);
  say(stdout, "{:>10} {:>12.6g} {:>12.5g} {:>14.6g} {:>14.6g} {:>9} {:>9}{}\n",
      model.steps, model.time, model.time_step.dt, sum.kinetic_energy,
      sum.worst_overlap, sum.active_contacts, model.search.updates,
      ratio_shown_ ? ratios_of(model) : "");
  std::fflush(stdout);
}

void Console::warn(const std::string& message) {
  if (receiver_)
    return receiver_(message);
  clear_progress();
  say(stderr, "warning: {}\n", message);
}

void Console::note(const std::string& message) {
  if (quiet_)
    return;
  clear_progress();
  say(stderr, "{}\n", message);
}

bool Console::is_progress_due() const {
  constexpr Clock::duration between_drawings = std::chrono::milliseconds(100);
  return !quiet_ &&
         Clock::now() - drawn_ >= (terminal_ ? between_drawings : between_log_lines_);
}

void Console::progress(const Model& model, double share, const Balance& balance) {
  drawn_ = Clock::now();
  const RunProgress run{
      share,         std::chrono::duration<double>(drawn_ - start_).count(),
      model.steps,   model.time,
      totals(model), balance};
  if (terminal_) {
    // A line that fills the last column would be wrapped by some terminals.
    say(stderr, "\r\033[K{}", progress_line(run, terminal_width() - 1));
    line_shown_ = true;
  } else {
    say(stderr, "{}\n", log_line(run));
  }
  std::fflush(stderr);
}

void Console::clear_progress() {
  if (line_shown_)
    say(stderr, "\r\033[K");
  line_shown_ = false;
}

}  // namespace blocks::run
