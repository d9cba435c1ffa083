// The time that each phase of a run takes: `blocks run --profile`.
#pragma once

#include <array>
#include <chrono>

namespace blocks::dynamics {

/// The wall clock time of each phase of a run. Most of them are phases of a step. Also
/// counts how often the filters of the predicates left a decision to exact arithmetic.
struct Profile {
  enum Phase { building, search, decisions, forces, motion, output, phases };

  std::array<double, phases> seconds{};
  /// [s] The part of `seconds` in which all threads work. The rest is serial: one
  /// thread works while the others wait.
  std::array<double, phases> shared{};
  double in_workers = 0.0;  ///< [s] the time of all calls so far (Workers::measure)
  unsigned long long exact_calls = 0;

  /// Adds the elapsed time to the current phase until the timer is destroyed. With a
  /// null profile it does nothing.
  class Timer {
   public:
    Timer(Profile* profile, Phase phase) : profile_(profile), phase_(phase) {
      if (profile_ != nullptr)
        began_ = std::chrono::steady_clock::now(), in_workers_ = profile_->in_workers;
    }
    ~Timer() { next(phase_); }
    /// Ends the current phase and begins another one.
    void next(Phase phase) {
      if (profile_ == nullptr)
        return;
      const auto now = std::chrono::steady_clock::now();
      profile_->seconds[phase_] += std::chrono::duration<double>(now - began_).count();
      profile_->shared[phase_] += profile_->in_workers - in_workers_;
      phase_ = phase, began_ = now, in_workers_ = profile_->in_workers;
    }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

   private:
    Profile* profile_;
    Phase phase_;
    std::chrono::steady_clock::time_point began_;
    double in_workers_ = 0.0;
  };
};

}  // namespace blocks::dynamics
