// The filters of geometry/contact_predicates.hpp for several lanes at once: plain loops
// over fixed arrays, which compilers turn into vector instructions. Each lane computes
// the same value and bound as the scalar filter, so the answers agree to the bit. The
// scalar predicate decides the lanes that are left undecided
// (docs/predicates.md#batches).
// Tests and measurements use this header; the kernels of a step have their own form.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/contact_predicates.hpp"

namespace blocks::geometry {

/// Number of lanes of a batch: one for each corner of a block with up to four corners.
/// A batch fills two or four vector registers.
inline constexpr std::size_t batch_lanes = 4;

/// One point per lane, [L].
struct Points {
  alignas(32) std::array<double, batch_lanes> xs;
  alignas(32) std::array<double, batch_lanes> ys;

  /// The same point in all lanes.
  static Points all(const Vec2& v) {
    Points points;
    points.xs.fill(v.x());
    points.ys.fill(v.y());
    return points;
  }
  void set(std::size_t lane, const Vec2& v) { xs[lane] = v.x(), ys[lane] = v.y(); }
  Vec2 operator[](std::size_t lane) const { return {xs[lane], ys[lane]}; }
};

/// The verdict of the filters for each lane: +1 certainly true (or positive), -1
/// certainly false (or negative), 0 undecided. Verdicts are doubles, so that the
/// results of comparisons stay in the same registers.
struct Answers {
  alignas(32) std::array<double, batch_lanes> verdict;

  bool yes(std::size_t lane) const { return verdict[lane] > 0; }
  bool no(std::size_t lane) const { return verdict[lane] < 0; }
  bool undecided(std::size_t lane) const { return verdict[lane] == 0; }

  bool all_yes() const {
    double sum = 0.0;
    for (const double v : verdict)
      sum += v;
    return sum == static_cast<double>(batch_lanes);
  }
  bool any_no() const {
    double lowest = 1.0;
    for (const double v : verdict)
      lowest = filter::least(lowest, v);
    return lowest < 0.0;
  }
};

namespace batch {

/// The point of one lane, held by value so that the compiler keeps it in registers.
struct Lane {
  double px, py;

  Lane(const Points& points, std::size_t lane)
      : px(points.xs[lane]), py(points.ys[lane]) {}
  double x() const { return px; }
  double y() const { return py; }
};

template <class Filter> inline Answers answers(Filter&& filter) {
  Answers found;
  for (std::size_t lane = 0; lane < batch_lanes; ++lane) {
    const filter::Estimate d = filter(lane);
    found.verdict[lane] = (d.positive() ? 1.0 : 0.0) - (d.negative() ? 1.0 : 0.0);
  }
  return found;
}

/// Each function is the filter of the scalar predicate of the same name, lane by lane.
/// in_reach_of_edge uses only its common bound. For signs, yes means +1 and no means
/// -1.
inline Answers overlap_sign(const Points& c, const Points& p1, const Points& p2) {
  return answers([&](std::size_t i) {
    return filter::overlap(Lane(c, i), Lane(p1, i), Lane(p2, i));
  });
}

inline Answers near_or_inside(const Points& c, const Points& p1, const Points& p2) {
  return answers([&](std::size_t i) {
    return filter::near_or_inside(Lane(c, i), Lane(p1, i), Lane(p2, i));
  });
}

inline Answers between(const Points& c, const Points& p1, const Points& p2) {
  return answers([&](std::size_t i) {
    return filter::between(Lane(c, i), Lane(p1, i), Lane(p2, i));
  });
}

inline Answers within_depth(const Points& c, const Points& centroid, const Points& p1,
                            const Points& p2) {
  return answers([&](std::size_t i) {
    return filter::above_centroid(Lane(c, i), Lane(centroid, i), Lane(p1, i),
                                  Lane(p2, i));
  });
}

inline Answers in_reach_of_edge(const Points& c, const Points& centroid,
                                const Points& p1, const Points& p2) {
  return answers([&](std::size_t i) {
    return filter::in_reach_of_edge(Lane(c, i), Lane(centroid, i), Lane(p1, i),
                                    Lane(p2, i));
  });
}

inline Answers faces_edge(const Points& c, const Points& neighbour, const Points& p1,
                          const Points& p2) {
  return answers([&](std::size_t i) {
    return filter::faces_edge(Lane(c, i), Lane(neighbour, i), Lane(p1, i), Lane(p2, i));
  });
}

inline Answers compare_depth(const Points& c, const Points& p1, const Points& p2,
                             const Points& q1, const Points& q2) {
  return answers([&](std::size_t i) {
    return filter::depth_difference(Lane(c, i), Lane(p1, i), Lane(p2, i), Lane(c, i),
                                    Lane(q1, i), Lane(q2, i));
  });
}

}  // namespace batch

/// Tests near_or_inside of one corner for the edges of all lanes. Lanes that the filter
/// leaves undecided are decided one by one. Guarantee: equal to the conjunction of the
/// scalar answers.
inline bool near_or_inside_all(const Vec2& c, const Points& p1, const Points& p2) {
  const Answers found = batch::near_or_inside(Points::all(c), p1, p2);
  if (found.any_no())
    return false;
  if (found.all_yes()) [[likely]]
    return true;
  for (std::size_t lane = 0; lane < batch_lanes; ++lane)
    if (found.undecided(lane) && !near_or_inside(c, p1[lane], p2[lane]))
      return false;
  return true;
}

}  // namespace blocks::geometry
