// PRIVATE to geometry/: intervals of doubles that enclose exact points, for decisions
// that need no exact numbers.
#pragma once

#include <CGAL/Interval_nt.h>

#include <cmath>
#include <limits>
#include <optional>

#include "geometry/cut.hpp"

namespace blocks::geometry::exact {

/// Rounding must be upwards while these are used.
using Interval = CGAL::Interval_nt<false>;

/// Rounds upwards, or to the nearest double, as long as it exists.
struct RoundUpwards : CGAL::Protect_FPU_rounding<true> {
  RoundUpwards() : CGAL::Protect_FPU_rounding<true>(CGAL_FE_UPWARD) {}
};
struct RoundToNearestAgain : CGAL::Protect_FPU_rounding<true> {
  RoundToNearestAgain() : CGAL::Protect_FPU_rounding<true>(CGAL_FE_TONEAREST) {}
};

/// A box that contains a point.
struct Enclosure {
  Interval x, y;
};

/// Encloses a number whose nearest double is given: it is half a unit away at most.
inline Interval around(double nearest) {
  // The least normal double is the least unit, because processors are slow with less.
  const double unit = std::abs(nearest) * 0x1p-52 + std::numeric_limits<double>::min();
  return {-(unit - nearest), nearest + unit};
}
inline Enclosure around(const Vec2& nearest) {
  return {around(nearest.x()), around(nearest.y())};
}

inline Enclosure enclosure(const ExactPoint& p) {
  const Vec2& nearest = p.nearest();
  return p.packed() != nullptr
             ? around(nearest)
             : Enclosure{Interval(nearest.x()), Interval(nearest.y())};
}

inline Enclosure operator-(const Enclosure& a, const Enclosure& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Interval cross(const Enclosure& a, const Enclosure& b) {
  return a.x * b.y - a.y * b.x;
}

/// The sign of a number in the interval, if it is the same for all of them.
inline std::optional<int> certain_sign(const Interval& value) {
  if (value.inf() > 0.0)
    return 1;
  if (value.sup() < 0.0)
    return -1;
  if (value.inf() == 0.0 && value.sup() == 0.0)
    return 0;
  return {};
}

/// The order of two numbers in the intervals, likewise; negative if a < b.
inline std::optional<int> certain_order(const Interval& a, const Interval& b) {
  if (a.sup() < b.inf())
    return -1;
  if (a.inf() > b.sup())
    return 1;
  if (a.inf() == a.sup() && b.inf() == b.sup())
    return 0;
  return {};
}
/// Likewise of two points, in x, then y.
inline std::optional<int> certain_order(const Enclosure& a, const Enclosure& b) {
  const auto by_x = certain_order(a.x, b.x);
  return by_x == 0 ? certain_order(a.y, b.y) : by_x;
}

}  // namespace blocks::geometry::exact
