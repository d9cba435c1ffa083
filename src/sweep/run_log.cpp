#include "sweep/run_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "output/file_tools.hpp"
#include "output/results.hpp"

namespace blocks::sweep {

namespace {

/// Throws output::FileError if the folder of a run, or that of 1000 runs, is a link.
void expect_no_link(const std::filesystem::path& run_folder) {
  std::error_code ignored;
  for (const auto& folder : {run_folder.parent_path(), run_folder})
    if (std::filesystem::is_symlink(folder, ignored))
      throw output::FileError(
          fmt::format("cannot write to {}: it is a link", folder.string()));
}

}  // namespace

RunLog::RunLog(const std::string& run_folder) : path_(run_folder + '/' + file_name) {
  const int flags = O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK,
            mode = 0666;
  expect_no_link(run_folder);
  file_ = ::open(path_.c_str(), flags, mode);
  if (file_ < 0 && errno == ENOENT) {
    output::create_folder_of(path_);
    file_ = ::open(path_.c_str(), flags, mode);
  }
  if (file_ < 0 && errno == ELOOP)
    output::expect_replaceable(path_);  // says that it is a link
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
