#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/joint_sources.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

/// Whether two segments cross in the box, in plain doubles.
bool cross_in_box(const JointSegment& s, const JointSegment& t, const Vec2& low,
                  const Vec2& high) {
  const Vec2 a = s.from.nearest(), along = s.to.nearest() - a, c = t.from.nearest(),
             other = t.to.nearest() - c;
  const double area = cross(along, other);
  if (area == 0.0)
    return false;
  const double at = cross(c - a, other) / area, at_other = cross(c - a, along) / area;
  if (!(at >= 0.0 && at <= 1.0 && at_other >= 0.0 && at_other <= 1.0))
    return false;
  const Vec2 place = a + at * along;
  return (place.array() >= low.array()).all() && (place.array() <= high.array()).all();
}

}  // namespace

double likely_crossings(const std::vector<JointSegment>& segments, const Vec2& low,
                        const Vec2& high) {
  constexpr double most = 1e5;
  const auto n = static_cast<double>(segments.size());
  const double pairs = 0.5 * n * (n - 1.0);
  double found = 0.0;
  if (pairs <= most) {
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        found += cross_in_box(segments[i], segments[j], low, high) ? 1.0 : 0.0;
    return found;
  }
  std::uint64_t state = 1;
  const auto any = [&] {  // a multiplier of Knuth's MMIX
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>((state >> 33) % segments.size());
  };
  for (double k = 0.0; k < most; ++k)
    found += cross_in_box(segments[any()], segments[any()], low, high) ? 1.0 : 0.0;
  return pairs * found / most;
}

}  // namespace blocks::geometry
