#include "model/cracks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blocks {

double CrackRecord::angle() const {
  const Vec2 along = to - from;
  const double degrees = std::atan2(along.y(), along.x()) * (180.0 / std::numbers::pi);
  constexpr double rounding = 1e-9;  // a horizontal chord has the angle 0
  if (std::abs(degrees) < rounding || std::abs(degrees) > 180.0 - rounding)
    return 0.0;
  return degrees < 0.0 ? degrees + 180.0 : degrees;
}

std::size_t count_refused(const std::vector<RefusedCrack>& all, CrackRefusal why) {
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(),
                    [&](const RefusedCrack& refused) { return refused.why == why; }));
}

bool refuse_crack(std::vector<RefusedCrack>& all, const RefusedCrack& refused) {
  const auto at = std::lower_bound(all.begin(), all.end(), refused);
  if (at != all.end() && *at == refused)
    return false;
  all.insert(at, refused);
  return true;
}

const char* describe(CrackRefusal why) {
  switch (why) {
  case CrackRefusal::small:
    return "a piece would be smaller than amin";
  case CrackRefusal::thin:
    return "a piece would be too thin for the time step";
  case CrackRefusal::corners:
    return "a piece would have more corners than START allows";
  case CrackRefusal::full:
    return "START allows no more blocks";
  case CrackRefusal::unsound:
    return "the certificate of the cut does not hold";
  }
  return "";
}

}  // namespace blocks
