// What a run shows: the short table on standard output, warnings and a progress line
// with the time remaining on standard error (the line on a terminal only).
#pragma once

#include <chrono>
#include <string>

#include "model/model.hpp"

namespace blocks::run {

class Console {
 public:
  /// table: the short table is wanted on standard output.
  Console(bool table, bool quiet);

  void row(const Model& model);
  void warn(const std::string& message);
  void note(const std::string& message);  ///< not when quiet
  /// Whether the line of progress is to be drawn: ten times a second at most.
  bool progress_due() const;
  /// Draws it. `share` of the whole run, 0 to 1.
  void progress(const Model& model, double share);
  void clear_progress();

 private:
  using Clock = std::chrono::steady_clock;
  bool table_, quiet_, terminal_;
  bool header_shown_ = false, line_shown_ = false;
  long last_step_ = -1;
  Clock::time_point start_ = Clock::now(), drawn_ = Clock::now();
};

}  // namespace blocks::run
