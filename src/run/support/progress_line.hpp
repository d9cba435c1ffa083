// The text of the progress line of a run.
#pragma once

#include <string>

#include "model/local_ratio.hpp"
#include "model/model.hpp"

namespace blocks::run {

/// How far a run has got.
struct RunProgress {
  double share;  ///< completed share of the whole run, 0 to 1
  double spent;  ///< wall-clock time since the start, [s]
  long steps;
  double time;
  ModelTotals totals;
  /// The ratios of the unbalanced forces during SOLVE; NaN otherwise.
  Balance balance = {};
};

/// Returns "12 s", "3 min 04 s" or "2 h 05 min".
std::string duration(double seconds);

/// Returns a bar and the state of the run in at most `width` characters. If they do not
/// fit, the bar gets shorter; then the energy, the contacts, the step, the time, the
/// local ratio with its block and the ratio are left out, in this order.
std::string progress_line(const RunProgress& run, int width);

/// Returns the same as a line of a log, without a bar.
std::string log_line(const RunProgress& run);

}  // namespace blocks::run
