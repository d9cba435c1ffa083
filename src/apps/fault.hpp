// Reports an exception that ends a command.
#pragma once

#include <stdexcept>

namespace blocks::apps {

/// Prints the message. Returns the exit code: that of a file error for
/// files::FileError, otherwise that of a usage error.
int tell_fault(const std::runtime_error& error);

}  // namespace blocks::apps
