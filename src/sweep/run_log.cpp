#include "sweep/run_log.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>

#include "output/file_tools.hpp"
#include "output/results.hpp"

namespace blocks::sweep {

RunLog::RunLog(const std::string& run_folder) : path_(run_folder + '/' + file_name) {
  const int flags = O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, mode = 0666;
  file_ = ::open(path_.c_str(), flags, mode);
  if (file_ < 0 && errno == ENOENT) {
    output::create_folder_of(path_);
    file_ = ::open(path_.c_str(), flags, mode);
  }
  if (file_ < 0)
    output::throw_errno("write", path_);
}

RunLog::~RunLog() { ::close(file_); }

bool RunLog::lock() {
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK)
      return false;
    output::throw_errno("lock", path_);
  }
  begin_ = ::lseek(file_, 0, SEEK_END);
  return true;
}

void RunLog::take_streams() const {
  std::cout.flush();
  std::fflush(nullptr);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    if (::dup2(file_, stream) < 0)
      output::throw_errno("write", path_);
}

std::string RunLog::fault() const {
  std::cout.flush();
  std::fflush(nullptr);
  std::ifstream in(path_, std::ios::binary);
  in.seekg(begin_);
  std::string warning;
  for (std::string line; std::getline(in, line);) {
    const std::string error_mark = "error: ", warning_mark = "warning: ";
    if (const auto at = line.find(error_mark); at != std::string::npos)
      return line.substr(at + error_mark.size());
    if (const auto at = line.find(warning_mark); at != std::string::npos)
      warning = line.substr(at + warning_mark.size());
  }
  return warning;
}

}  // namespace blocks::sweep
