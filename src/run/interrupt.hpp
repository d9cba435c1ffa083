// Handles Ctrl-C and SIGTERM: the run finishes its step, writes a checkpoint and stops.
#pragma once

#include <functional>

namespace blocks::run {

/// Installs the signal handlers, unless an InterruptPoll exists. A second signal ends
/// the program at once.
void catch_interrupts();
bool interrupt_requested();

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
