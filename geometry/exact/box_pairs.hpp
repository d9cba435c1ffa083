// PRIVATE to geometry/: finds pairs of outlines whose bounding boxes intersect, in O(n
// log n) time. It uses the streamed segment tree of Zomorodian and Edelsbrunner, in
// CGAL.
#pragma once

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/step_progress.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry::exact {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;

/// Returns the bounding box of a non-empty outline, enlarged by `reach` [L] on all
/// sides.
inline Box box_of(const Polygon& outline, std::size_t number, double reach = 0.0) {
  Vec2 low = outline.front();
  Vec2 high = outline.front();
  for (const Vec2& corner : outline) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  low.array() -= reach;
  high.array() += reach;
  double lower[2] = {low.x(), low.y()};
  double upper[2] = {high.x(), high.y()};
  return {lower, upper, number};
}

/// Pairs (i, j), visited in the order of i. Outlines with near numbers are usually near
/// each other, so they stay in the caches.
class PairBatch {
 public:
  static constexpr std::size_t max = 1U << 24;  ///< 130 MB

  bool is_full() const { return pairs_.size() == max; }
  void add(std::size_t i, std::size_t j) {
    pairs_.emplace_back(static_cast<std::uint32_t>(std::min(i, j)),
                        static_cast<std::uint32_t>(std::max(i, j)));
  }
  /// Visits and removes all pairs. count: of outlines.
  template <typename Visit> void visit(std::size_t count, Visit& visit) {
    std::vector<std::uint32_t> first(count + 1, 0), second(pairs_.size());
    for (const auto& [i, j] : pairs_)
      ++first[i + 1];
    for (std::size_t i = 0; i < count; ++i)
      first[i + 1] += first[i];
    for (const auto& [i, j] : pairs_)
      second[first[i]++] = j;  // then first[i] is the end of the pairs of i
    pairs_.clear();
    for (std::size_t i = 0, k = 0; i < count; ++i)
      for (; k < first[i]; ++k)
        visit(i, std::size_t{second[k]});
  }

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
};

/// Calls visit(i, j), i < j, once for every two outlines whose boxes, each enlarged by
/// its reach, share a point. If `reach` is empty, the boxes must share an interior
/// point. progress: may be null; counts the pairs that are found.
template <typename Visit>
void for_each_close_pair(const std::vector<Polygon>& outlines,
                         const std::vector<double>& reach, Visit visit,
                         StepProgress* progress = nullptr) {
  std::vector<Box> boxes;
  boxes.reserve(outlines.size());
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (!outlines[i].empty())
      boxes.push_back(box_of(outlines[i], i, reach.empty() ? 0.0 : reach[i]));
  PairBatch pairs;
  CGAL::box_self_intersection_d(
      boxes.begin(), boxes.end(),
      [&](const Box& a, const Box& b) {
        if (progress)
          progress->count(0, 1);
        if (pairs.is_full())
          pairs.visit(outlines.size(), visit);
        pairs.add(a.info(), b.info());
      },
      std::ptrdiff_t{10},
      reach.empty() ? CGAL::Box_intersection_d::HALF_OPEN
                    : CGAL::Box_intersection_d::CLOSED);
  pairs.visit(outlines.size(), visit);
}

}  // namespace blocks::geometry::exact
