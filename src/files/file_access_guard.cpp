#include "files/file_access_guard.hpp"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

namespace blocks::files {
namespace {

thread_local const FileAccessGuard* in_hand = nullptr;
int exit_code = 5;

void tell(std::string_view text) {
  if (write(STDERR_FILENO, text.data(), text.size()) < 0)
    _exit(exit_code);
}

/// Requests SIGVTALRM after this processor time; 0 cancels it.
void limit_processor_time(int seconds) {
  const itimerval once{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_VIRTUAL, &once, nullptr);
}

}  // namespace

FileAccessGuard::FileAccessGuard(const char* verb, const std::string& path) noexcept
    : outer_(in_hand), verb_(verb), path_(path) {
  in_hand = this;
}

FileAccessGuard::~FileAccessGuard() {
  in_hand = outer_;
  if (timed_)
    limit_processor_time(0);
}

/// Allocates no memory, because the heap may be damaged.
void file_crash(int signal) {
  std::signal(signal, SIG_DFL);
  if (in_hand == nullptr) {
    std::raise(signal);
    return;
  }
  tell("blocks: error: cannot ");
  tell(in_hand->verb_);
  tell(" ");
  tell(in_hand->path_);
  tell(": it is damaged, HDF5 failed on it\n");
  _exit(exit_code);
}

void FileAccessGuard::must_end_within(int seconds) noexcept {
  timed_ = true;
  std::signal(SIGVTALRM, file_crash);
  limit_processor_time(seconds);
}

void tell_crashes_of_files(int code) {
  exit_code = code;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT})
    std::signal(signal, file_crash);
}

}  // namespace blocks::files
