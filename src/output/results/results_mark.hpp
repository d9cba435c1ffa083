// The mark at the head of a results file: 512 bytes of text that HDF5 does not use (its
// user block). It holds the number of changes of the file, which is odd during a
// change. A reader compares the numbers before and after and reads again if they
// differ. Only bytes and a file lock are used, not HDF5.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "files/opened_file.hpp"

namespace blocks::output {

constexpr std::size_t mark_size = 512;
constexpr std::string_view results_head = "BLOCKS r";  ///< the first 8 bytes

/// The writer's side. The file has an advisory lock during the lifetime of the object.
/// The lock distinguishes a change in progress from one whose writer died.
class ChangeMark {
 public:
  ChangeMark() = default;
  /// Writes the mark of a new file. Throws hdf5::Failure.
  static ChangeMark make(const std::string& path);
  /// Finds the mark of an existing file. A file without a mark does not get one. Throws
  /// hdf5::Failure.
  static ChangeMark find(const std::string& path);
  ChangeMark(ChangeMark&&) noexcept = default;
  ChangeMark& operator=(ChangeMark&&) noexcept = default;
  /// Ends a change in progress. Everything written so far is kept.
  ~ChangeMark();

  /// Makes the number odd. Call it before the first byte changes; a second call has no
  /// effect. Throws hdf5::Failure.
  void begin();
  /// Makes the number even. Call it after the last byte has changed. Throws
  /// hdf5::Failure.
  void end();

 private:
  ChangeMark(const std::string& path, bool is_new);
  void write(std::uint64_t number);
  files::OpenedFile file_;
  std::uint64_t number_ = 0;
};

/// Whether a writer holds the lock, as a run does until its end. False if the file
/// system has no locks.
bool is_being_written(const std::string& path);

/// The reader's side.
class ChangeWatch {
 public:
  /// Opens the file. A file that cannot be opened or has no mark counts as one that
  /// never changes.
  explicit ChangeWatch(const std::string& path);

  /// The number of changes of the file; 0 without a mark.
  std::uint64_t number() const;
  /// Waits until no change is in progress or its writer has died, and returns the
  /// number. Returns nothing if `until` comes first.
  std::optional<std::uint64_t>
  settled(std::chrono::steady_clock::time_point until) const;
  /// Whether `path` still names the opened file.
  bool still_named(const std::string& path) const;

 private:
  files::OpenedFile file_;
};

}  // namespace blocks::output
