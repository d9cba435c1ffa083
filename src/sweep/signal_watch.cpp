#include "sweep/signal_watch.hpp"

namespace blocks::sweep {
namespace {

constexpr int watched[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t signals = 0, last_signal = 0;

void on_signal(int signal) {
  last_signal = signal;
  signals = signals + 1;
}

}  // namespace

SignalWatch::SignalWatch() {
  signals = 0;
  last_signal = 0;
  struct sigaction action {};
  action.sa_handler = on_signal;  // without SA_RESTART: a signal ends poll()
  for (std::size_t i = 0; i < std::size(watched); ++i) {
    ::sigaction(watched[i], &action, &before_[i]);
    if (before_[i].sa_handler == SIG_IGN)
      ::sigaction(watched[i], &before_[i], nullptr);
  }
}

SignalWatch::~SignalWatch() {
  for (std::size_t i = 0; i < std::size(watched); ++i)
    ::sigaction(watched[i], &before_[i], nullptr);
}

SignalWatch::Asked SignalWatch::asked() {
  using namespace std::chrono_literals;
  const int now = signals;
  if (now == seen_)
    return Asked::nothing;
  const bool first = seen_ == 0;
  seen_ = now;
  if (first) {
    first_ = Clock::now();
    return Asked::stop;
  }
  return Clock::now() - first_ < 1s ? Asked::nothing : Asked::kill;
}

int SignalWatch::signal() const { return last_signal; }

}  // namespace blocks::sweep
