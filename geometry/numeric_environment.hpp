// Checks and sets the floating-point state that the proofs of the predicates assume.
#pragma once

#include <string>

namespace blocks::geometry {

/// Returns an empty string if the calling thread rounds to nearest and keeps subnormal
/// numbers, otherwise a sentence that says what is wrong. Call it at the start of every
/// thread that steps the model.
std::string check_numeric_environment();

/// Sets rounding to nearest and restores the previous mode on destruction. The results
/// of geometry then do not depend on the rounding mode of the caller.
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
