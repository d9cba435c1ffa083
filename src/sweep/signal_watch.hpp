// Receives the signals that ask a sweep to stop.
#pragma once

#include <chrono>
#include <csignal>

namespace blocks::sweep {

/// Catches SIGINT, SIGTERM and SIGHUP as long as it exists. One that the program was
/// started to ignore, as by nohup, is left alone. There is at most one object at a
/// time.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// What the signals ask for now.
  enum class Asked {
    nothing,
    stop,  ///< returned once, after the first signal
    kill   ///< after each further one that comes more than a second later: a shell or a
           ///< batch system may send one signal twice
  };
  Asked asked();
  /// The last signal; 0 before the first one.
  int signal() const;

 private:
  using Clock = std::chrono::steady_clock;
  int seen_ = 0;
  Clock::time_point first_;
  struct sigaction before_[3]{};
};

}  // namespace blocks::sweep
