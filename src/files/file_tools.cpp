#include "files/file_tools.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace blocks::files {
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

/// Returns whether a new, empty file was created; errno tells why not.
bool create_new(const std::string& path) {
  constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  const int descriptor = ::open(path.c_str(), flags, 0666);
  if (descriptor >= 0)
    ::close(descriptor);
  return descriptor >= 0;
}

}  // namespace

void expect_replaceable(const std::string& path) {
  std::error_code ignored;
  const auto there = std::filesystem::symlink_status(path, ignored);
  if (std::filesystem::is_symlink(there))
    throw FileError("cannot write " + path + ": it is a link; choose another name");
  if (std::filesystem::is_directory(there))
    throw FileError("cannot write " + path +
                    ": it is a folder; give the name of a file");
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
    throw FileError("cannot write " + path +
                    ": it is not a regular file; choose another name");
}

void expect_regular(const std::string& path) {
  using Type = std::filesystem::file_type;
  const auto refuse = [&](const char* what) {
    throw FileError(fmt::format("cannot read {}: it is {}", path, what));
  };
  std::error_code ignored;
  switch (std::filesystem::status(path, ignored).type()) {
  case Type::directory:
    refuse("a folder");
    break;
  case Type::fifo:
    refuse("a FIFO, not a regular file");
    break;
  case Type::character:
  case Type::block:
    refuse("a device, not a regular file");
    break;
  case Type::socket:
    refuse("a socket, not a regular file");
    break;
  default:
    break;  // opening a missing file reports why
  }
}

bool has_text(const std::string& path, std::int64_t at, std::string_view text) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(path, ignored)))
    return false;
  std::ifstream in(path, std::ios::binary);
  std::string head(text.size(), '\0');
  return in.seekg(at).read(head.data(), static_cast<std::streamsize>(head.size())) &&
         head == text;
}

void expect_no_link(const std::string& folder) {
  std::error_code ignored;
  if (std::filesystem::is_symlink(folder, ignored))
    throw FileError(fmt::format("cannot write to {}: it is a link", folder));
}

namespace {

bool is_there(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(std::filesystem::symlink_status(path, ignored));
}

/// Returns the first of .bak, .bak2, ... that is free.
std::string free_ending(const std::string& path) {
  std::string ending = ".bak";
  for (int number = 2; is_there(path + ending); ++number)
    ending = fmt::format(".bak{}", number);
  return ending;
}

bool have_same_content(const std::string& a, const std::string& b) {
  std::error_code fault;
  if (std::filesystem::file_size(a, fault) != std::filesystem::file_size(b, fault) ||
      fault)
    return false;
  std::ifstream one(a, std::ios::binary), other(b, std::ios::binary);
  return std::equal(std::istreambuf_iterator<char>(one), {},
                    std::istreambuf_iterator<char>(other), {});
}

}  // namespace

std::string set_aside(const std::string& path) {
  if (!is_there(path))
    return {};
  const std::string ending = free_ending(path);
  move_file(path, path + ending);
  return ending;
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

void create_new_file(const std::string& path) {
  if (!create_new(path))
    throw_errno("write", path);
}

TemporaryFile::TemporaryFile(const std::string& name) : name_(name) {
  expect_replaceable(name_);
  std::string path = name_ + ".tmp";
  for (int number = 2; !create_new(path); ++number) {
    if (errno != EEXIST)
      throw_errno("write", name_);
    path = fmt::format("{}.tmp{}", name_, number);
  }
  path_ = std::move(path);
}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty())
    ::unlink(path_.c_str());
}

void TemporaryFile::take_name() {
  move_file(path_, name_);
  path_.clear();
}

void TemporaryFile::take_name_keeping_older(const std::string& aside) {
  expect_replaceable(name_);
  if (aside.empty() && is_there(name_) && have_same_content(name_, path_))
    return take_name();
  const std::string older = name_ + (aside.empty() ? free_ending(name_) : aside);
  expect_replaceable(older);
  // There may be none, or another program may set it aside at this moment.
  if (std::rename(name_.c_str(), older.c_str()) != 0 && errno != ENOENT)
    throw_errno("write", older);
  take_name();
}

namespace {

void write_all(const TemporaryFile& temporary, const std::string& path,
               const std::string& content) {
  errno = 0;
  std::ofstream file(temporary.path(), std::ios::binary);
  file << content;
  file.close();
  if (!file)
    throw_errno("write", path);
}

}  // namespace

void replace_file(const std::string& path, const std::string& content) {
  TemporaryFile temporary(path);
  write_all(temporary, path, content);
  temporary.take_name();
}

void replace_file_keeping_older(const std::string& path, const std::string& content) {
  TemporaryFile temporary(path);
  write_all(temporary, path, content);
  temporary.take_name_keeping_older();
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

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return std::filesystem::exists(a, ignored) && std::filesystem::exists(b, ignored) &&
         std::filesystem::equivalent(a, b, ignored);
}

}  // namespace blocks::files
