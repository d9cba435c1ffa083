// The progress line of CUT cards, and of the check of the blocks, that take long, on
// standard error.
#pragma once

#include <chrono>
#include <string>

namespace blocks::run {

class CutProgress {
 public:
  /// Instead of the line of a card: no two blocks are to overlap.
  static constexpr int check = -1;

  explicit CutProgress(bool quiet);

  /// Shows the line if the card has taken two seconds: again and again in one place on
  /// a terminal, every ten seconds in a log. part: the part of the work that is done;
  /// at 1 the line is removed. Throws Interrupted if an interrupt is requested.
  void operator()(int line, const std::string& step, double part);

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_;
  int line_ = 0;  ///< of the card
  bool shown_ = false;
  Clock::time_point start_, drawn_;
};

}  // namespace blocks::run
