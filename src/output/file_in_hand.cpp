#include "output/file_in_hand.hpp"

#include <unistd.h>

#include <csignal>

namespace blocks::output {
namespace {

thread_local const FileInHand* in_hand = nullptr;
int exit_code = 5;

}  // namespace

FileInHand::FileInHand(const char* verb, const std::string& path)
    : outer_(in_hand), message_("blocks: error: cannot " + (verb + (" " + path)) +
                                ": it is damaged, HDF5 failed in it\n") {
  in_hand = this;
}

FileInHand::~FileInHand() { in_hand = outer_; }

/// Async-signal-safe: the message was made before.
void file_crash(int signal) {
  std::signal(signal, SIG_DFL);
  if (in_hand != nullptr &&
      write(STDERR_FILENO, in_hand->message_.data(), in_hand->message_.size()) >= 0)
    _exit(exit_code);
  std::raise(signal);
}

void tell_crashes_of_files(int code) {
  exit_code = code;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT})
    std::signal(signal, file_crash);
}

}  // namespace blocks::output
