// A results file of one Simulation: no other one of this program writes to it
// meanwhile.
#pragma once

#include <filesystem>
#include <string>

#include "output/results.hpp"

namespace blocks::library {

/// The place in the file system that a path leads to: one for w, ./w and linked/w. A
/// link in the place of the file itself would be replaced, and is not followed.
std::filesystem::path file_of(const std::string& path);

/// The one writer of a file, for as long as it lives.
class FileClaim {
 public:
  /// Throws output::FileError if the file is claimed already.
  explicit FileClaim(const std::string& path);
  ~FileClaim();
  FileClaim(const FileClaim&) = delete;
  FileClaim& operator=(const FileClaim&) = delete;

 private:
  std::filesystem::path file_;
};

class ResultsInUse {
 public:
  /// Throws output::FileError: another one writes to it, or it cannot be written.
  ResultsInUse(const std::string& path, const output::RunIdentity& identity)
      : claim_(path), writer_(path, identity) {}

  /// Appends the state; does nothing if it is the last frame already. changes: count of
  /// what was done to the model from outside.
  void write(const Model& model, long changes);

 private:
  FileClaim claim_;
  output::ResultsWriter writer_;
  long written_changes_ = -1;
};

}  // namespace blocks::library
