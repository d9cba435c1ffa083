// Where the time of a run goes: `blocks run --profile`.
#pragma once

#include <array>
#include <chrono>

namespace blocks::dynamics {

/// Wall clock of the phases of a run, most of them of a step, and how often the filters
/// of the predicates left a decision to exact arithmetic.
struct Profile {
  enum Phase { building, search, decisions, forces, motion, output, phases };

  std::array<double, phases> seconds{};
  unsigned long long exact_calls = 0;

  /// Adds the time of its life to one phase; a null profile costs nothing.
  class Timer {
   public:
    Timer(Profile* profile, Phase phase) : profile_(profile), phase_(phase) {
      if (profile_ != nullptr)
        began_ = std::chrono::steady_clock::now();
    }
    ~Timer() {
      if (profile_ != nullptr)
        profile_->seconds[phase_] +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began_)
                .count();
    }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

   private:
    Profile* profile_;
    Phase phase_;
    std::chrono::steady_clock::time_point began_;
  };
};

}  // namespace blocks::dynamics
