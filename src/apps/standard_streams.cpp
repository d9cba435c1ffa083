#include "standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "run/run.hpp"

namespace blocks::apps {
namespace {

/// The action of SIGPIPE before outlive_broken_pipes(); SIG_ERR if it was not called.
void (*pipe_action)(int) = SIG_ERR;

/// Returns why writing failed. The C library does not keep the reason, so another byte
/// is written to get errno again.
const char* why_not(int stream) {
  return ::write(stream, "\n", 1) == 1 ? "part of it is missing" : std::strerror(errno);
}

}  // namespace

void hold_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF)
      // Opens in the wrong direction, so that reading or writing still fails. open()
      // returns the lowest free descriptor, which is this stream.
      static_cast<void>(
          ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

void outlive_broken_pipes() { pipe_action = std::signal(SIGPIPE, SIG_IGN); }

int end_standard_output(int code) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
    return code;
  if (code != run::done)
    return code;
  if (pipe_action != SIG_ERR)
    std::signal(SIGPIPE, pipe_action);
  const char* const reason = why_not(STDOUT_FILENO);  // a broken pipe ends here
  std::fprintf(stderr, "blocks: error: cannot write standard output: %s\n", reason);
  return run::file_error;
}

}  // namespace blocks::apps
