// HDF5 1.10 can crash on a damaged file: a wrong size deep in its metadata makes it
// write outside its own memory. Such files cannot be detected in advance. The program
// therefore ends with a message that names the file and exit code 5, not with a core
// dump.
#pragma once

#include <string>

namespace blocks::files {

/// Marks the file that HDF5 is accessing during the lifetime of the object.
class FileAccessGuard {
 public:
  /// `verb` appears in the message, such as "read". `path` must outlive the object.
  FileAccessGuard(const char* verb, const std::string& path) noexcept;
  ~FileAccessGuard();
  /// Limits the processor time for closing a damaged file that was open for writing,
  /// which HDF5 may never finish. After `seconds` the program ends as after a crash.
  void must_end_within(int seconds) noexcept;
  FileAccessGuard(const FileAccessGuard&) = delete;
  FileAccessGuard& operator=(const FileAccessGuard&) = delete;

 private:
  const FileAccessGuard* outer_;
  const char* verb_;
  const std::string& path_;
  bool timed_ = false;
  friend void file_crash(int);
};

/// After this call, a crash during the lifetime of a FileAccessGuard prints "blocks:
/// error: cannot read NAME: it is damaged" and ends the program with `code`. Other
/// crashes are not affected.
void tell_crashes_of_files(int code);

}  // namespace blocks::files
