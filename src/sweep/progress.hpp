// How far a sweep has got.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <string>

namespace blocks::sweep {

/// The number of runs with each status; the status of runs without outcome is "open".
using Counts = std::map<std::string, std::size_t>;

/// Returns the counts in one line, "done" first: "62 done, 1 unsound, 1 open".
std::string words_of(const Counts& counts);

/// The progress line of a sweep on standard error. On a terminal it is drawn again and
/// again in one place; in a log, a line appears every minute.
class Progress {
 public:
  /// `before` runs of `all` were finished when it began.
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
