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
  const Vec2 a = s.from.nearest(), b = s.to.nearest(), c = t.from.nearest(),
             d = t.to.nearest();
  for (const int axis : {0, 1})
    if (std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
        std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]))
      return false;
  const Vec2 along = b - a, other = d - c;
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
                        const Vec2& high, const ProgressFunction& progress) {
  StepProgress estimating(progress, "estimate crossings");
  // A pair takes some nanoseconds, so all take a tenth of a second. Fewer segments than
  // the least number would say little about the others.
  constexpr std::size_t max_pairs = 10'000'000, min = 64;
  const std::size_t n = segments.size();
  if (n < 2)
    return 0.0;
  const std::size_t sample_size = std::min(std::max(max_pairs / n, min), n);
  std::vector<JointSegment> some;
  std::uint64_t state = 1;
  for (std::size_t i = 0; i < sample_size; ++i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;  // Knuth's MMIX
    some.push_back(segments[sample_size == n ? i : (state >> 33) % n]);
  }
  double found = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    for (const JointSegment& one : some) {
      estimating.count(i, n);
      found += cross_in_box(one, segments[i], low, high) ? 1.0 : 0.0;
    }
  // Each crossing has two segments.
  return 0.5 * found * static_cast<double>(n) / static_cast<double>(sample_size);
}

}  // namespace blocks::geometry
