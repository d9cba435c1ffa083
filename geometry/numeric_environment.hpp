// Is the floating-point unit in the state the predicates were proved for?
#pragma once

#include <string>

namespace blocks::geometry {

/// Empty if the calling thread rounds to nearest and keeps subnormal numbers; otherwise
/// a sentence that says what is wrong. Call it at the start of every thread that steps.
std::string check_numeric_environment();

/// Rounds to nearest for the life of the object, then as before: the answers of
/// geometry do not depend on the rounding mode of whoever asks.
class RoundToNearest {
 public:
  RoundToNearest();
  ~RoundToNearest();
  RoundToNearest(const RoundToNearest&) = delete;
  RoundToNearest& operator=(const RoundToNearest&) = delete;

 private:
  int before_;
};

}  // namespace blocks::geometry
