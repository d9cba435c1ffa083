// Calls other programs: sbatch, squeue, scontrol, parallel.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace blocks::sweep {

/// Returns the path of a program of this name in PATH; empty if there is none.
std::string find_program(const std::string& name);

/// Returns the path of this program.
std::string this_program();

struct ProgramEnd {
  int code = 0;        ///< exit code, or 128 + signal; 127 if it cannot start
  std::string output;  ///< standard output without the line end
};

/// Calls a program, words[0] in PATH, and waits for it. Throws std::system_error if no
/// process can be made.
ProgramEnd call_program(const std::vector<std::string>& words);

/// A program at work in a process group of its own, so that Ctrl-C does not reach it.
class ProgramProcess {
 public:
  /// Starts words[0] in PATH. Throws std::system_error if it cannot start.
  explicit ProgramProcess(const std::vector<std::string>& words);
  /// Kills it if it is still at work.
  ~ProgramProcess();
  ProgramProcess(const ProgramProcess&) = delete;
  ProgramProcess& operator=(const ProgramProcess&) = delete;

  bool has_ended();
  /// Returns the exit code, or 128 + signal, after it has ended.
  int code() const { return code_; }
  void send(int signal) const;

 private:
  pid_t process_ = -1;
  int code_ = 0;
};

/// Returns the words as a line for a POSIX shell.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace blocks::sweep
