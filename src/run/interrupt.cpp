#include "run/interrupt.hpp"

#include <csignal>
#include <utility>

namespace blocks::run {
namespace {

volatile std::sig_atomic_t requested = 0;
thread_local std::function<bool()> polled;

void on_signal(int signal) {
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

InterruptPoll::InterruptPoll(std::function<bool()> poll) { polled = std::move(poll); }
InterruptPoll::~InterruptPoll() { polled = nullptr; }

}  // namespace blocks::run
