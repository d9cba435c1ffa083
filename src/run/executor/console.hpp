// The terminal output of a run. The table goes to standard output; warnings and the
// progress line with the remaining time go to standard error. On a terminal, the
// progress line is drawn again and again in one place. In a log, a plain line appears
// now and then.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>

#include "model/model.hpp"
#include "run/support/progress_line.hpp"

namespace blocks::run {

class Console {
 public:
  /// `table` requests the table on standard output. A run of less than a minute thus
  /// adds no progress line to a log.
  Console(bool table, bool quiet,
          std::chrono::seconds between_log_lines = std::chrono::minutes(1));

  void row(const Model& model);
  /// Adds the ratio of the unbalanced forces, the largest local ratio and its block to
  /// the rows. Call it before the first one.
  void show_ratio() { ratio_shown_ = true; }
  void warn(const std::string& message);
  /// From now on, warnings are not printed, but given to this function.
  void give_warnings_to(std::function<void(const std::string&)> warn) {
    receiver_ = std::move(warn);
  }
  void note(const std::string& message);  ///< suppressed by `quiet`
  /// Whether the progress line is due. A terminal gets it at most ten times a second.
  bool is_progress_due() const;
  /// Draws the progress line, which fits the present width of the terminal. `share` is
  /// the completed share of the whole run, 0 to 1. `balance` has the ratios during
  /// SOLVE.
  void progress(const Model& model, double share, const Balance& balance = {});
  void clear_progress();

 private:
  using Clock = std::chrono::steady_clock;
  std::function<void(const std::string&)> receiver_;  ///< of warnings; empty: none
  bool table_, quiet_, terminal_;
  Clock::duration between_log_lines_;
  bool ratio_shown_ = false, header_shown_ = false, line_shown_ = false;
  long last_step_ = -1;
  Clock::time_point start_ = Clock::now(), drawn_ = Clock::now();
};

}  // namespace blocks::run
