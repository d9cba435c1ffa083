// The results file of a Simulation. Only one Simulation of a program may write to a
// results file at a time.
#pragma once

#include <filesystem>
#include <string>

#include "files/name_lock.hpp"
#include "output/results/results.hpp"

namespace blocks::library {

/// The canonical form of a path, so that w, ./w and linked/w give the same result.
/// Symbolic links in the folder are followed. A link at the file name itself is not,
/// because writing would replace it.
std::filesystem::path file_of(const std::string& path);

/// The output name that a run with these results has: the path without .vtkhdf.
std::string name_of(const std::string& path);

/// Reserves a file for one writer during the lifetime of the object.
class FileClaim {
 public:
  /// Throws files::FileError if the file is already reserved.
  explicit FileClaim(const std::string& path);
  ~FileClaim();
  FileClaim(const FileClaim&) = delete;
  FileClaim& operator=(const FileClaim&) = delete;

 private:
  std::filesystem::path file_;
};

class ResultsInUse {
 public:
  /// Throws files::FileError if another Simulation or program writes to the file, or
  /// if it cannot be written.
  ResultsInUse(const std::string& path, const output::RunIdentity& identity)
      : claim_(path), lock_(name_of(path), path), writer_(path, identity) {}

  /// Appends the state, unless it is already the last frame. `changes` counts the
  /// changes made to the model between steps.
  void write(const Model& model, long changes);

 private:
  FileClaim claim_;  ///< also where a file system has no locks
  files::NameLock lock_;
  output::ResultsWriter writer_;
  long written_changes_ = -1;
};

}  // namespace blocks::library
