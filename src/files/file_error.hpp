// The exception of files.
#pragma once

#include <stdexcept>
#include <string>

namespace blocks::files {

/// Thrown if a file cannot be written or read; the exit code is 5.
class FileError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws FileError: "cannot VERB NAME: " and the message of errno.
[[noreturn]] void throw_errno(const char* verb, const std::string& path);

}  // namespace blocks::files
