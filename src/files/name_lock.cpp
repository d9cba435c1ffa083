#include "files/name_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>

#include "files/file_tools.hpp"

namespace blocks::files {
namespace {

constexpr std::string_view head = "BLOCKS lock of ";

/// Returns the head of the file. A new file is empty.
std::string content_of(int file) {
  std::array<char, 256> text{};
  const ssize_t size = ::pread(file, text.data(), text.size(), 0);
  return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

/// Describes this process, and its machine because folders may be shared.
std::string this_process() {
  std::array<char, 256> machine{};
  ::gethostname(machine.data(), machine.size() - 1);
  return fmt::format("process {} on {}", ::getpid(), machine.data());
}

/// Returns the process that has the lock, in brackets; empty if it is not known yet.
std::string owner_in(std::string text) {
  text = text.substr(0, text.find('\n'));
  return text.starts_with(head) ? fmt::format(" ({})", text.substr(head.size())) : "";
}

[[noreturn]] void refuse(const std::string& meant, const std::string& reason) {
  throw FileError(fmt::format("cannot write {}: {}", meant, reason));
}

bool is_still_named(int file, const std::string& path) {
  struct stat held, named;
  return ::fstat(file, &held) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

}  // namespace

NameLock::NameLock(const std::string& name, const std::string& meant)
    : path_(name + ".lock") {
  // Another program may remove its file after it was opened here.
  do {
    constexpr int flags = O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK;
    file_ = OpenedFile(::open(path_.c_str(), flags, 0666));
    if (!file_ && (errno == ELOOP || errno == EISDIR || errno == ENXIO))
      refuse(meant, path_ + " is not a regular file; remove it");
    if (!file_)
      throw_errno("write", meant);
    struct stat state;
    const std::string content = content_of(file_.get());
    if (::fstat(file_.get(), &state) != 0 || !S_ISREG(state.st_mode) ||
        !(content.empty() || content.starts_with(head)))
      refuse(meant, path_ + " is not a lock of BLOCKS; rename it");
    if (::flock(file_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      refuse(meant,
             fmt::format("another program is writing it{}; use -o NAME for other "
                         "files",
                         owner_in(content_of(file_.get()))));
  } while (!is_still_named(file_.get(), path_));
  // The text only informs, so failures are ignored.
  const std::string text = fmt::format("{}{}\n", head, this_process());
  if (::ftruncate(file_.get(), 0) == 0 &&
      ::pwrite(file_.get(), text.data(), text.size(), 0) < 0)
    errno = 0;
}

NameLock::~NameLock() {
  if (is_still_named(file_.get(), path_))
    ::unlink(path_.c_str());
}

}  // namespace blocks::files
