// Runs a program as a user starts it, and measures its time.
#pragma once

#include <string>
#include <vector>

namespace blocks::bench {

/// Seconds: user-mode processor time of all threads, and wall-clock time.
struct RunSeconds {
  double user = 0.0, clock = 0.0;
};

/// Runs `words`, a program and its arguments, and returns the time it took. Throws
/// std::runtime_error if it cannot be started or fails.
RunSeconds run_child(std::vector<std::string> words);

}  // namespace blocks::bench
