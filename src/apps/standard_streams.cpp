#include "standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "run/run.hpp"

namespace blocks::apps {
namespace {

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

int end_standard_output(int code) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
    return code;
  if (code != run::done)
    return code;
  std::fprintf(stderr, "blocks: error: cannot write standard output: %s\n",
               why_not(STDOUT_FILENO));
  return run::file_error;
}

}  // namespace blocks::apps
