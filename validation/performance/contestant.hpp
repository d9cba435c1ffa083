// A code that steps a scene and is compared with others.
#pragma once

#include <string>

namespace blocks::bench {

class Contestant {
 public:
  virtual ~Contestant() = default;
  virtual std::string name() const = 0;
  virtual int threads() const { return 1; }
  /// Is it timed by wall-clock time instead of processor time?
  virtual bool by_clock() const { return threads() > 1; }
  /// The units of work in one step, by which a time is divided: free blocks times the
  /// work on each.
  virtual double work_per_step() const = 0;
  /// Makes `steps` further steps.
  virtual void run(long steps) = 0;
};

}  // namespace blocks::bench
