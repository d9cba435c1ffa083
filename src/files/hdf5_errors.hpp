// Failures of HDF5 as messages that name the file.
#pragma once

#include <string>

#include "files/file_access_guard.hpp"
#include "files/file_error.hpp"
#include "files/hdf5_handle.hpp"

namespace blocks::files {

/// Runs `action` and converts hdf5::Failure to FileError: "cannot write NAME: reason".
template <class Action>
auto with_file_errors(const char* verb, const std::string& path, Action&& action) {
  const FileAccessGuard in_hand(verb, path);
  try {
    return action();
  } catch (const hdf5::Failure& failure) {
    throw FileError("cannot " + (verb + (" " + path)) + ": " + failure.what());
  }
}

}  // namespace blocks::files
