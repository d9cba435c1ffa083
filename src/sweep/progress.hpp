// The progress line of a sweep.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace blocks::sweep {

/// The progress line of a sweep on standard error. On a terminal it is drawn again and
/// again in one place; in a log, a line appears every minute.
class Progress {
 public:
  /// `before` of the `all` runs that it counts were finished when it began.
  Progress(std::size_t before, std::size_t all, bool quiet);

  bool is_due() const;
  /// Draws the line. `more` is put behind the number of finished runs.
  void show(std::size_t finished, const std::string& more = {});
  void clear();
  double seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t before_, all_;
  bool quiet_, terminal_, shown_ = false;
  Clock::time_point start_ = Clock::now(), drawn_ = start_;
};

}  // namespace blocks::sweep
