// What a command does with a fault it cannot mend.
#pragma once

#include <stdexcept>

namespace blocks::apps {

/// Prints it and returns the exit code: of a file (output::FileError), or of the usage.
int tell_fault(const std::runtime_error& error);

}  // namespace blocks::apps
