#include "run/support/cut_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "run/support/interrupt.hpp"
#include "run/support/progress_line.hpp"

namespace blocks::run {

CutProgress::CutProgress(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

void CutProgress::operator()(int line, const std::string& step, double part) {
  using std::chrono::seconds, std::chrono::milliseconds;
  const auto clear = [&] {
    if (terminal_ && shown_)
      std::fputs("\r\033[K", stderr);
    shown_ = false;
  };
  if (part < 1.0) {
    if (interrupt_requested())
      clear();
    stop_if_interrupted();
  }
  const Clock::time_point now = Clock::now();
  if (line != line_ || part >= 1.0) {
    clear();
    line_ = part < 1.0 ? line : 0;
    start_ = now;
    return;
  }
  const Clock::duration between =
      terminal_ ? Clock::duration(milliseconds(100)) : Clock::duration(seconds(10));
  if (quiet_ || now - start_ < seconds(2) || (shown_ && now - drawn_ < between))
    return;
  drawn_ = now;
  shown_ = true;
  const double spent = std::chrono::duration<double>(now - start_).count();
  const std::string left =
      part > 0.0 ? ", " + duration(spent * (1.0 - part) / part) + " left" : "";
  const std::string work =
      line == check ? "check" : fmt::format("CUT in line {}", line);
  std::fputs(fmt::format("{}{}: {}, {:.0f} %{}{}", terminal_ ? "\r\033[K" : "", work,
                         step, 100.0 * part, left, terminal_ ? "" : "\n")
                 .c_str(),
             stderr);
  std::fflush(stderr);
}

}  // namespace blocks::run
