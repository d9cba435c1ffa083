#include "sweep/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "run/support/progress_line.hpp"

namespace blocks::sweep {

Progress::Progress(std::size_t before, std::size_t all, bool quiet)
    : before_(before), all_(all), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {
}

double Progress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

bool Progress::is_due() const {
  using namespace std::chrono_literals;
  const auto between = terminal_ ? Clock::duration(100ms) : Clock::duration(1min);
  return !quiet_ && Clock::now() - drawn_ >= between;
}

void Progress::show(std::size_t finished, const std::string& more) {
  drawn_ = Clock::now();
  std::string line = fmt::format("{} of {} runs finished{}", finished, all_, more);
  if (const std::size_t made = finished - before_; made > 0)
    line += ", " +
            run::duration(seconds() * static_cast<double>(all_ - finished) /
                          static_cast<double>(made)) +
            " left";
  std::fputs((terminal_ ? "\r\x1b[K" + line : line + '\n').c_str(), stderr);
  std::fflush(stderr);
  shown_ = terminal_;
}

void Progress::clear() {
  if (shown_)
    std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace blocks::sweep
