#include "geometry/numeric_environment.hpp"

#include <cfenv>
#include <limits>

namespace blocks::geometry {

std::string check_numeric_environment() {
  if (std::fegetround() != FE_TONEAREST)
    return "the processor does not round to nearest";
  volatile double smallest = std::numeric_limits<double>::min();
  volatile double half = smallest / 2.0;  // subnormal
  if (half == 0.0 || half * 2.0 != smallest)
    return "the processor flushes subnormal numbers to zero";
  return {};
}

}  // namespace blocks::geometry
