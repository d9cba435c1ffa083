// The lock of an output name. Programs that write files of the same name, such as two
// runs of one deck, thus exclude each other before either touches a file.
#pragma once

#include <string>

#include "files/opened_file.hpp"

namespace blocks::files {

class NameLock {
 public:
  /// Creates and locks the file NAME.lock, which contains the number of the process.
  /// `meant` is the file for messages. Throws FileError if another program or object
  /// has the lock, or if NAME.lock is a link or a file of something else. On a file
  /// system without locks, nothing is locked.
  NameLock(const std::string& name, const std::string& meant);
  /// Removes the file. The lock of a killed program is free, although its file remains.
  ~NameLock();
  NameLock(const NameLock&) = delete;
  NameLock& operator=(const NameLock&) = delete;

 private:
  std::string path_;
  OpenedFile file_;
};

}  // namespace blocks::files
