// A run of a program as a user starts it, and what it cost.
#pragma once

#include <string>
#include <vector>

namespace blocks::bench {

/// Seconds: of the processor in user mode, of all threads, and on the clock.
struct RunSeconds {
  double user = 0.0, clock = 0.0;
};

/// What `words` (program, then arguments) took. Throws std::runtime_error when it
/// cannot be started or fails.
RunSeconds run_child(std::vector<std::string> words);

}  // namespace blocks::bench
