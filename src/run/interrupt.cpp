#include "run/interrupt.hpp"

#include <csignal>
#include <utility>

namespace blocks::run {
namespace {

volatile std::sig_atomic_t requested = 0;
thread_local std::function<bool()> polled;

void on_signal(int signal) {
  requested = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  if (polled)
    return;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupt_requested() { return polled ? polled() : requested != 0; }

InterruptPoll::InterruptPoll(std::function<bool()> poll) { polled = std::move(poll); }
InterruptPoll::~InterruptPoll() { polled = nullptr; }

}  // namespace blocks::run
