// PRIVATE to geometry/: boxes of segments, to find pairs that may meet. One box of a
// long slanted segment would meet most others, so it has several.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "geometry/exact/box_pairs.hpp"
#include "geometry/exact/enclosure.hpp"

namespace blocks::geometry::exact {

/// Appends boxes that enclose the part of from + s along with s in [begin, end], each
/// of a part whose larger component is about `longest`, [L]. Rounding must be upwards.
inline void add_boxes(const Enclosure& from, const Enclosure& along, double begin,
                      double end, double longest, std::size_t number,
                      std::vector<Box>& boxes) {
  const double length =
      (end - begin) * std::max(std::abs(along.x.sup()), std::abs(along.y.sup()));
  constexpr double max = 1024.0;  // for ends that are very far away
  const double count = std::min(std::max(1.0, std::ceil(length / longest)), max);
  const auto at = [&](double i) -> Enclosure {
    const Interval s =
        Interval(begin) + (Interval(end) - begin) * (Interval(i) / count);
    return {from.x + along.x * s, from.y + along.y * s};
  };
  const auto min = [](double a, double b) {
    constexpr double unbounded = -std::numeric_limits<double>::infinity();
    return a <= b ? a : b <= a ? b : unbounded;  // NaN after an overflow
  };
  Enclosure p = at(0.0);
  for (double i = 1.0; i <= count; ++i) {
    const Enclosure q = at(i);
    double low[2] = {min(p.x.inf(), q.x.inf()), min(p.y.inf(), q.y.inf())};
    double high[2] = {-min(-p.x.sup(), -q.x.sup()), -min(-p.y.sup(), -q.y.sup())};
    boxes.emplace_back(low, high, number);
    p = q;
  }
}

/// Likewise for the part of a segment inside a box, or more of it. low, high: the
/// nearest doubles of the corners of the box, [L].
inline void add_boxes(const ExactPoint& from, const ExactPoint& to, const Vec2& low,
                      const Vec2& high, double longest, std::size_t number,
                      std::vector<Box>& boxes) {
  const Enclosure p = enclosure(from), along = enclosure(to) - p;
  double begin = 0.0, end = 1.0;
  const auto clip = [&](const Interval& start, const Interval& run, double min,
                        double max) {
    if (run.inf() <= 0.0 && run.sup() >= 0.0)
      return;
    const Interval in = (min - start) / run, out = (max - start) / run;
    begin = std::max(begin, std::min(in.inf(), out.inf()));
    end = std::min(end, std::max(in.sup(), out.sup()));
  };
  const Enclosure first = around(low), last = around(high);
  clip(p.x, along.x, first.x.inf(), last.x.sup());
  clip(p.y, along.y, first.y.inf(), last.y.sup());
  if (begin <= end)
    add_boxes(p, along, begin, end, longest, number, boxes);
}

}  // namespace blocks::geometry::exact
