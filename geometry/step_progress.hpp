// Reports progress from inside long loops, and so lets the caller stop them by an
// exception.
#pragma once

#include <algorithm>
#include <functional>
#include <string>

namespace blocks::geometry {

/// Called with the name of a step and the part of all the work that is done, from 0 to
/// 1. It may throw to stop the work; what was computed is freed.
using ProgressFunction = std::function<void(const std::string& step, double part)>;

/// One step of the work, which takes it from part `begin` to part `end`.
class StepProgress {
 public:
  StepProgress(const ProgressFunction& function, const char* step, double begin = 0.0,
               double end = 1.0)
      : function_(&function), step_(step), begin_(begin), end_(end) {
    report(0.0);
  }
  /// Counts one unit of work. Returns whether a report is due, which is so after each
  /// `units_per_report` units.
  bool is_due() {
    if (++units_ < units_per_report)
      return false;
    units_ = 0;
    return static_cast<bool>(*function_);
  }
  /// Reports that a part of this step is done. The part never decreases.
  void report(double part) {
    done_ = std::max(done_, std::min(part, 1.0));
    if (*function_)
      (*function_)(step_, begin_ + done_ * (end_ - begin_));
  }
  /// Counts one unit of work. `done` of `all` units are complete.
  void count(std::size_t done, std::size_t all) {
    if (is_due())
      report(static_cast<double>(done) /
             static_cast<double>(std::max<std::size_t>(all, 1)));
  }

 private:
  // A unit takes between 50 ns and 50 us, so reports are 0.05 to 50 ms apart. A larger
  // number would delay the end of an interrupted run.
  static constexpr int units_per_report = 1024;

  const ProgressFunction* function_;
  std::string step_;
  double begin_, end_;
  double done_ = 0.0;
  int units_ = 0;
};

}  // namespace blocks::geometry
