// Runs a program as a user starts it, and measures its cost.
#pragma once

#include <string>
#include <vector>

namespace blocks::bench {

/// What a program and the programs that it started took.
struct RunCost {
  double user = 0.0;    ///< [s] processor time of all threads in user mode
  double system = 0.0;  ///< [s] processor time in the kernel
  double clock = 0.0;   ///< [s] wall-clock time
  double memory = 0.0;  ///< [bytes] largest resident memory of one process
};

/// Runs `words`, a program and its arguments, and returns its cost. What it prints on
/// standard output is discarded. Throws std::runtime_error if it cannot be started or
/// fails.
RunCost run_child(std::vector<std::string> words);

}  // namespace blocks::bench
