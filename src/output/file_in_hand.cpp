#include "output/file_in_hand.hpp"

#include <unistd.h>

#include <csignal>
#include <string_view>

namespace blocks::output {
namespace {

thread_local const FileInHand* in_hand = nullptr;
int exit_code = 5;

void tell(std::string_view text) {
  if (write(STDERR_FILENO, text.data(), text.size()) < 0)
    _exit(exit_code);
}

}  // namespace

FileInHand::FileInHand(const char* verb, const std::string& path) noexcept
    : outer_(in_hand), verb_(verb), path_(path) {
  in_hand = this;
}

FileInHand::~FileInHand() { in_hand = outer_; }

/// Allocates nothing: the memory may be what was damaged.
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
  tell(": it is damaged, HDF5 failed in it\n");
  _exit(exit_code);
}

void tell_crashes_of_files(int code) {
  exit_code = code;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT})
    std::signal(signal, file_crash);
}

}  // namespace blocks::output
