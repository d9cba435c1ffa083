#include "output/file_tools.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace blocks::output {
namespace {

bool sync(const std::string& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0)
    return false;
  const bool synced = ::fsync(descriptor) == 0;
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return synced;
}

}  // namespace

void throw_errno(const char* verb, const std::string& path) {
  throw FileError(fmt::format("cannot {} {}: {}", verb, path,
                              std::generic_category().message(errno)));
}

void expect_replaceable(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::file_status there = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(there))
    throw FileError("cannot write " + path +
                    ": it is a folder; give the name of a file");
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
    throw FileError("cannot write " + path +
                    ": it is not a regular file; choose another name");
}

void create_folder_of(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  std::error_code fault;
  if (!folder.empty())
    std::filesystem::create_directories(folder, fault);
  if (fault)
    throw FileError(fmt::format("cannot create the folder {}: {}", folder.string(),
                                fault.message()));
}

void move_file(const std::string& from, const std::string& to) {
  expect_replaceable(from);
  expect_replaceable(to);
  if (std::rename(from.c_str(), to.c_str()) != 0)
    throw_errno("write", to);
}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty())
    ::unlink(path_.c_str());
}

void TemporaryFile::take_name(const std::string& name) {
  move_file(path_, name);
  path_.clear();
}

void replace_file(const std::string& path, const std::string& content) {
  TemporaryFile temporary(path + ".tmp");
  std::ofstream file(temporary.path(), std::ios::binary);
  file << content;
  file.close();
  if (!file)
    throw_errno("write", path);
  temporary.take_name(path);
}

void sync_file(const std::string& path, const std::string& meant) {
  if (!sync(path, O_RDONLY))
    throw_errno("write", meant);
}

void sync_folder_of(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  // Some file systems cannot sync a folder. The file itself is already on disk.
  if (!sync(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY) &&
      errno != EINVAL && errno != ENOTSUP && errno != EACCES)
    throw_errno("write", path);
}

std::string Fnv1a::text() const { return fmt::format("{:016x}", state_); }

}  // namespace blocks::output
