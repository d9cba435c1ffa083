// An estimate with its interval.
#pragma once

#include <limits>

namespace blocks::joints {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The confidence of all intervals.
inline constexpr double confidence = 0.95;

/// A value and the interval that covers the true one with the confidence. Each is NaN
/// if it is not known.
struct Estimate {
  double value = unknown, low = unknown, high = unknown;
};

}  // namespace blocks::joints
