#include "sweep/run_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "files/file_tools.hpp"

namespace blocks::sweep {

namespace {

/// Throws files::FileError unless this is a regular file that has no other name.
/// Otherwise the log would be written into another file of the user.
void expect_own_file(int file, const std::string& path) {
  struct stat state {};
  if (::fstat(file, &state) != 0)
    files::throw_errno("write", path);
  const char* const fault = !S_ISREG(state.st_mode) ? "it is not a regular file"
                            : state.st_nlink > 1    ? "it is a hard link; remove it"
                                                    : nullptr;
  if (fault != nullptr)
    throw files::FileError(fmt::format("cannot write {}: {}", path, fault));
}

/// Opens the log, and creates it if it is missing. Returns its descriptor.
int open_log(const std::string& path) {
  const int flags = O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK,
            mode = 0666;
  int file = ::open(path.c_str(), flags, mode);
  if (file < 0 && errno == ENOENT) {
    files::create_folder_of(path);
    file = ::open(path.c_str(), flags, mode);
  }
  if (file < 0) {
    const int reason = errno;
    files::expect_replaceable(path);  // says that it is a link, a FIFO or a folder
    errno = reason;
    files::throw_errno("write", path);
  }
  return file;
}

}  // namespace

RunLog::RunLog(const std::string& run_folder) : path_(run_folder + '/' + file_name) {
  // The folder of 1000 runs and that of all runs may be links, too.
  const std::filesystem::path thousand =
      std::filesystem::path(run_folder).parent_path();
  files::expect_no_link(thousand.parent_path().string());
  files::expect_no_link(thousand.string());
  files::expect_no_link(run_folder);
  file_ = open_log(path_);
  try {
    expect_own_file(file_, path_);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

RunLog::~RunLog() { ::close(file_); }

bool RunLog::lock() {
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK)
      return false;
    files::throw_errno("lock", path_);
  }
  begin_ = ::lseek(file_, 0, SEEK_END);
  return true;
}

void RunLog::take_streams() const {
  std::cout.flush();
  std::fflush(nullptr);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    if (::dup2(file_, stream) < 0)
      files::throw_errno("write", path_);
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
