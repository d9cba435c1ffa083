// Codes that step the same scene, measured against each other.
#pragma once

#include <string>

namespace blocks::bench {

class Contestant {
 public:
  virtual ~Contestant() = default;
  virtual std::string name() const = 0;
  virtual int threads() const { return 1; }
  /// Whether it is timed by the clock on the wall, else by the processor's.
  virtual bool by_clock() const { return threads() > 1; }
  /// Free blocks times what one step does to each: the number a time is divided by.
  virtual double work_per_step() const = 0;
  /// Goes on by so many steps.
  virtual void run(long steps) = 0;
};

}  // namespace blocks::bench
