// Handles the signals that ask a run to end: Ctrl-C (SIGINT), SIGTERM, the end of the
// session (SIGHUP) and of the processor time (SIGXCPU). The run finishes its step,
// writes a checkpoint and stops.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace blocks::run {

/// Installs the signal handlers, unless an InterruptPoll exists. A second SIGINT,
/// SIGTERM or SIGHUP ends the program at once. SIGHUP remains ignored if it is ignored
/// at the start, as nohup does.
void catch_interrupts();
bool interrupt_requested();

/// Thrown if an interrupt stops the work on a card.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Throws Interrupted if an interrupt is requested.
void stop_if_interrupted();

/// While it exists, a signal ends the process at once, because there is nothing to
/// save: memory of gigabytes would take long to be freed. Has no effect if an
/// InterruptPoll exists. Only one may exist at a time.
class EndAtOnce {
 public:
  /// Requires catch_interrupts(). message: written to standard error. code: of the
  /// process.
  EndAtOnce(const std::string& message, int code);
  ~EndAtOnce();
  EndAtOnce(const EndAtOnce&) = delete;
  EndAtOnce& operator=(const EndAtOnce&) = delete;
};

/// For programs that handle signals themselves: while it exists, runs of this thread
/// install no handlers, and ask this function whether to stop.
class InterruptPoll {
 public:
  explicit InterruptPoll(std::function<bool()> poll);
  ~InterruptPoll();
  InterruptPoll(const InterruptPoll&) = delete;
  InterruptPoll& operator=(const InterruptPoll&) = delete;
};

}  // namespace blocks::run
