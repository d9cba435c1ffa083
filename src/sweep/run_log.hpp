// The log of a run, log.txt: what the run prints. It is also the lock of its folder.
#pragma once

#include <string>

namespace blocks::sweep {

class RunLog {
 public:
  /// Opens the log of a run, and creates its folder if it is missing. Throws
  /// output::FileError.
  explicit RunLog(const std::string& run_folder);
  ~RunLog();
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;

  /// Returns whether this process alone has the run now. The lock ends with the object
  /// or with the process.
  bool lock();
  /// Makes standard output and error of this process write to the log.
  void take_streams() const;
  /// Returns the first error since lock(), without "error: " and what is before it;
  /// otherwise the last warning. Empty if there is neither.
  std::string fault() const;

 private:
  std::string path_;
  int file_;
  long begin_ = 0;  ///< length of the log when it was locked
};

}  // namespace blocks::sweep
