#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/exact/box_pairs.hpp"
#include "geometry/exact/shared_point.hpp"
#include "geometry/joint_sources.hpp"
#include "geometry/numeric_environment.hpp"

namespace blocks::geometry {
namespace {

using exact::Point;
using exact::Rational;
using exact::Vector;

// A trace p + s * (q - p). The part with s in [begin, end] remains; s = 1/2 is the
// middle.
struct Trace {
  Point from;
  Vector along;
  Rational begin = 0, end = 1;

  void meet(const Rational& s) {
    if (s < 0 || s > 1)
      return;
    const bool is_before = 2 * s <= 1;
    if (is_before && s > begin)
      begin = s;
    if (!is_before && s < end)
      end = s;
  }
};

exact::Box box_of(const Point& p, const Point& q, std::size_t number) {
  const Vec2 a = exact::nearest(p), b = exact::nearest(q);
  // Encloses the exact points, whose distance to the nearest doubles is below an ulp.
  const double slack =
      0x1p-50 * std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>()) +
      std::numeric_limits<double>::denorm_min();
  return exact::box_of({a, b}, number, slack);
}

// Ends the trace where it meets the joint. Joints along the trace do not end it.
void end_at(const Point& from, const Point& to, Trace& trace) {
  const Vector side = to - from, to_joint = from - trace.from;
  const Rational turn = exact::cross(trace.along, side);
  if (turn == 0)
    return;
  const Rational on_joint = exact::cross(to_joint, trace.along) / turn;
  if (on_joint >= 0 && on_joint <= 1)
    trace.meet(exact::cross(to_joint, side) / turn);
}

}  // namespace

std::vector<JointSegment> ended_at(const std::vector<JointSegment>& traces,
                                   const std::vector<JointSegment>& joints,
                                   const ProgressFunction& progress) {
  const RoundToNearest mode;
  StepProgress reading(progress, "end traces", 0.0, 0.3);
  std::vector<Trace> parts;
  std::vector<exact::Box> probes, boxes;
  for (std::size_t i = 0; i < traces.size(); ++i) {
    reading.count(i, traces.size());
    const Point from = exact::point_of(traces[i].from),
                to = exact::point_of(traces[i].to);
    parts.push_back({from, to - from});
    probes.push_back(box_of(from, to, i));
  }
  std::vector<std::pair<Point, Point>> ends;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    ends.emplace_back(exact::point_of(joints[i].from), exact::point_of(joints[i].to));
    boxes.push_back(box_of(ends[i].first, ends[i].second, i));
  }
  StepProgress meeting(progress, "end traces", 0.3, 1.0);
  CGAL::box_intersection_d(probes.begin(), probes.end(), boxes.begin(), boxes.end(),
                           [&](const exact::Box& probe, const exact::Box& box) {
                             meeting.count(0, 1);
                             const auto& [from, to] = ends[box.info()];
                             end_at(from, to, parts[probe.info()]);
                           });
  std::vector<JointSegment> out;
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const Trace& part = parts[i];
    out.push_back(traces[i]);
    if (part.begin > 0)
      out.back().from = exact::exact_point(part.from + part.along * part.begin);
    if (part.end < 1)
      out.back().to = exact::exact_point(part.from + part.along * part.end);
  }
  return out;
}

}  // namespace blocks::geometry
