#include "geometry/numeric_environment.hpp"

#include <cfenv>
#include <limits>

namespace blocks::geometry {

std::string check_numeric_environment() {
  // volatile forces the computation at run time; the compiler must not fold it.
  volatile const double one = 1.0;
  volatile const double above_half_ulp = 0x1.8p-53;
  volatile const double below_half_ulp = 0x1p-54;
  volatile const double half = 0.5;
  volatile const double smallest_normal = std::numeric_limits<double>::min();
  volatile const double smallest = std::numeric_limits<double>::denorm_min();

  const bool up = one + above_half_ulp > one;
  const bool down = one + below_half_ulp == one;
  const bool up_negative = -one - above_half_ulp < -one;
  const bool down_negative = -one - below_half_ulp == -one;
  if (std::fegetround() != FE_TONEAREST || !up || !down || !up_negative ||
      !down_negative)
    return "floating-point rounding is not to nearest: contact decisions would not be "
           "reliable";
  // DAZ is tested first, because under DAZ a subnormal product would also compare as
  // zero.
  const double scaled = smallest * 0x1p60;
  if (!(scaled > 0))
    return "subnormal floating-point arguments are read as zero (DAZ): was a part of "
           "the "
           "program built with -ffast-math?";
  const double product = smallest_normal * half;
  if (!(product > 0))
    return "floating-point results are flushed to zero when subnormal (FTZ): was a "
           "part "
           "of the program built with -ffast-math?";
  return {};
}

RoundToNearest::RoundToNearest() : before_(std::fegetround()) {
  if (before_ != FE_TONEAREST)
    std::fesetround(FE_TONEAREST);
}

RoundToNearest::~RoundToNearest() {
  if (before_ != FE_TONEAREST)
    std::fesetround(before_);
}

}  // namespace blocks::geometry
