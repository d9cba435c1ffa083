// HDF5 1.10 does not survive every damaged file: a wrong size deep in its metadata
// makes it write beside its own memory. What cannot be refused is at least told: the
// program ends with the file's name and exit code 5 instead of a core dump.
#pragma once

#include <string>

namespace blocks::output {

/// The file that HDF5 is made to read, for as long as this lives.
class FileInHand {
 public:
  /// verb: "read"; path must outlive this.
  FileInHand(const char* verb, const std::string& path) noexcept;
  ~FileInHand();
  /// HDF5 may go on for ever closing a damaged file that was open for writing: after
  /// these seconds of processor time that is told like a crash.
  void must_end_within(int seconds) noexcept;
  FileInHand(const FileInHand&) = delete;
  FileInHand& operator=(const FileInHand&) = delete;

 private:
  const FileInHand* outer_;
  const char* verb_;
  const std::string& path_;
  bool timed_ = false;
  friend void file_crash(int);
};

/// From here on a crash with a file in hand prints "blocks: error: cannot read NAME: it
/// is damaged" and ends the program with `code`; any other crash stays what it was.
void tell_crashes_of_files(int code);

}  // namespace blocks::output
