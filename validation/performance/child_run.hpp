// A run of a program as a user starts it, and what it cost.
#pragma once

#include <string>
#include <vector>

namespace blocks::bench {

/// Seconds of the processor in user mode that `words` (program, then arguments) took.
/// Throws std::runtime_error when it cannot be started or fails.
double user_seconds(std::vector<std::string> words);

}  // namespace blocks::bench
