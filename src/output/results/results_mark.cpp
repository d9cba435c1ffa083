#include "output/results/results_mark.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <ctime>
#include <string_view>
#include <thread>

#include "files/hdf5_handle.hpp"

namespace blocks::output {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view words = "BLOCKS results; HDF5 from byte 512 on. Changes: ";
constexpr int digits = 20;

[[noreturn]] void fail() { throw hdf5::Failure(std::strerror(errno)); }

void put(int file, std::string_view text, std::size_t at) {
  while (!text.empty()) {
    const ssize_t done =
        ::pwrite(file, text.data(), text.size(), static_cast<off_t>(at));
    if (done < 0 && errno == EINTR)
      continue;
    if (done <= 0)
      fail();
    text.remove_prefix(static_cast<std::size_t>(done));
    at += static_cast<std::size_t>(done);
  }
}

std::optional<std::uint64_t> number_in(int file) {
  std::array<char, words.size() + digits> head{};
  if (file < 0 || ::pread(file, head.data(), head.size(), 0) != ssize_t{head.size()} ||
      std::string_view(head.data(), words.size()) != words)
    return {};
  std::uint64_t number = 0;
  std::from_chars(head.data() + words.size(), head.data() + head.size(), number);
  return number;
}

bool is_odd(std::uint64_t number) { return number % 2 != 0; }

/// Whether the writer of an odd number has died. If the file system has no locks,
/// whether the file was last written more than a minute ago.
bool abandoned(int file) {
  if (::flock(file, LOCK_SH | LOCK_NB) == 0) {
    ::flock(file, LOCK_UN);
    return true;
  }
  struct stat state;
  constexpr std::time_t long_ago = 60;
  return errno != EWOULDBLOCK && errno != EINTR && ::fstat(file, &state) == 0 &&
         std::time(nullptr) - state.st_mtime > long_ago;
}

}  // namespace

ChangeMark::ChangeMark(const std::string& path, bool is_new)
    : file_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {
  if (!file_)
    fail();
  if (is_new) {
    std::string head(mark_size, ' ');
    head.replace(0, words.size(), words);
    head.back() = '\n';
    put(file_.get(), head, 0);
    write(0);
  } else if (const auto found = number_in(file_.get())) {
    number_ = *found;
  } else {
    file_ = files::OpenedFile();
    return;
  }
  // A reader may hold the lock for a moment. The loop ends at once if there are no
  // locks.
  for (int i = 0; i < 100 && ::flock(file_.get(), LOCK_EX | LOCK_NB) != 0 &&
                  (errno == EWOULDBLOCK || errno == EINTR);
       ++i)
    std::this_thread::sleep_for(1ms);
}

bool is_being_written(const std::string& path) {
  const files::OpenedFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  return file && ::flock(file.get(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

ChangeMark ChangeMark::make(const std::string& path) { return {path, true}; }
ChangeMark ChangeMark::find(const std::string& path) { return {path, false}; }

ChangeMark::~ChangeMark() {
  try {
    end();
  } catch (...) {  // the number stays odd and the lock is free
  }
}

void ChangeMark::write(std::uint64_t number) {
  put(file_.get(), fmt::format("{:0{}}", number, digits), words.size());
  number_ = number;
}

void ChangeMark::begin() {
  if (file_ && !is_odd(number_))
    write(number_ + 1);
}

void ChangeMark::end() {
  if (file_ && is_odd(number_))
    write(number_ + 1);
}

ChangeWatch::ChangeWatch(const std::string& path)
    : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}

std::uint64_t ChangeWatch::number() const { return number_in(file_.get()).value_or(0); }

std::optional<std::uint64_t>
ChangeWatch::settled(std::chrono::steady_clock::time_point until) const {
  for (auto pause = 1ms;; pause = std::min(2 * pause, 20ms)) {
    const std::uint64_t now = number();
    if (!is_odd(now))
      return now;
    if (abandoned(file_.get()))
      return now;
    if (std::chrono::steady_clock::now() > until)
      return {};
    std::this_thread::sleep_for(pause);
  }
}

bool ChangeWatch::still_named(const std::string& path) const {
  struct stat held, named;
  return !file_ ||
         (::fstat(file_.get(), &held) == 0 && ::stat(path.c_str(), &named) == 0 &&
          held.st_dev == named.st_dev && held.st_ino == named.st_ino);
}

}  // namespace blocks::output
