// The log of a run, log.txt, has everything that the run prints. A process that runs it
// holds a lock on this file.
#pragma once

#include <string>

namespace blocks::sweep {

class RunLog {
 public:
  static constexpr const char* file_name = "log.txt";

  /// Opens the log of a run, and creates its folder if it is missing. Throws
  /// files::FileError, also if the log or its folder is a link, or the log has a
  /// second name.
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
