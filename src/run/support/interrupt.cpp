#include "run/support/interrupt.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <utility>

namespace blocks::run {
namespace {

volatile std::sig_atomic_t requested = 0;
thread_local std::function<bool()> polled;

// What EndAtOnce asks for. The handler reads it while `ends` is set.
volatile std::sig_atomic_t ends = 0;
std::array<char, 256> last_words;
std::size_t length_of_last_words = 0;
int last_code = 0;

void on_signal(int signal) {
  if (ends != 0) {
    [[maybe_unused]] const auto written =
        write(STDERR_FILENO, last_words.data(), length_of_last_words);
    _exit(last_code);
  }
  requested = 1;
  // The system repeats SIGXCPU every second; the checkpoint may take longer.
  if (signal != SIGXCPU)
    std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  if (polled)
    return;
  for (const int signal : {SIGINT, SIGTERM, SIGXCPU})
    std::signal(signal, on_signal);
  if (std::signal(SIGHUP, on_signal) == SIG_IGN)
    std::signal(SIGHUP, SIG_IGN);
}

bool interrupt_requested() { return polled ? polled() : requested != 0; }

void stop_if_interrupted() {
  if (interrupt_requested())
    throw Interrupted();
}

EndAtOnce::EndAtOnce(const std::string& message, int code) {
  if (polled)
    return;
  const std::string text =
      (isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "") + message;  // no progress line
  length_of_last_words = std::min(text.size(), last_words.size());
  std::copy_n(text.begin(), length_of_last_words, last_words.begin());
  last_code = code;
  ends = 1;
}
EndAtOnce::~EndAtOnce() { ends = 0; }

InterruptPoll::InterruptPoll(std::function<bool()> poll) { polled = std::move(poll); }
InterruptPoll::~InterruptPoll() { polled = nullptr; }

}  // namespace blocks::run
