#include <algorithm>
#include <limits>
#include <optional>

#include "geometry/exact/segment_boxes.hpp"
#include "geometry/exact/shared_point.hpp"
#include "geometry/joint_sources.hpp"
#include "geometry/numeric_environment.hpp"

namespace blocks::geometry {
namespace {

using exact::Enclosure;
using exact::Interval;
using exact::Point;
using exact::Rational;
using exact::RoundUpwards;
using exact::Vector;

// Where a trace p + s (q - p) meets a joint.
struct Meet {
  std::size_t joint;
  Interval s;  ///< encloses the parameter
};

// What remains of a trace, around its middle s = 1/2.
struct Part {
  std::optional<Meet> begin, end;
};

// Returns where the trace meets the joint. Joints along the trace do not end it.
std::optional<Rational> meet(const JointSegment& trace, const JointSegment& joint) {
  const Point start = exact::point_of(trace.from), from = exact::point_of(joint.from),
              to = exact::point_of(joint.to);
  const Vector along = exact::point_of(trace.to) - start, side = to - from,
               to_joint = from - start;
  const Rational turn = exact::cross(along, side);
  if (turn == 0)
    return {};
  const Rational on_joint = exact::cross(to_joint, along) / turn;
  if (on_joint < 0 || on_joint > 1)
    return {};
  const Rational s = exact::cross(to_joint, side) / turn;
  return s < 0 || s > 1 ? std::nullopt : std::optional(s);
}

class Ender {
 public:
  Ender(const std::vector<JointSegment>& traces,
        const std::vector<JointSegment>& joints)
      : traces_(traces), joints_(joints), parts_(traces.size()) {}

  std::vector<JointSegment> run(const ProgressFunction& progress) {
    StepProgress reading(progress, "end traces", 0.0, 0.2);
    std::vector<exact::Box> probes, boxes;
    fill(probes, boxes, reading);
    StepProgress meeting(progress, "end traces", 0.2, 0.8);
    CGAL::box_intersection_d(probes.begin(), probes.end(), boxes.begin(), boxes.end(),
                             [&](const exact::Box& probe, const exact::Box& box) {
                               meeting.count(0, 1);
                               test(probe.info(), box.info());
                             });
    StepProgress ending(progress, "end traces", 0.8, 1.0);
    std::vector<JointSegment> result = traces_;
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      ending.count(i, traces_.size());
      if (parts_[i].begin)
        result[i].from = place(i, *parts_[i].begin);
      if (parts_[i].end)
        result[i].to = place(i, *parts_[i].end);
    }
    return result;
  }

 private:
  // Joints are cut off at the box of the traces, and have boxes of the size of traces.
  void fill(std::vector<exact::Box>& probes, std::vector<exact::Box>& boxes,
            StepProgress& progress) const {
    if (traces_.empty() || joints_.empty())
      return;
    Vec2 low = traces_[0].from.nearest(), high = low;
    double sum = 0.0;
    for (const JointSegment& trace : traces_) {
      progress.count(0, 1);
      sum += (trace.to.nearest() - trace.from.nearest()).norm();
      for (const ExactPoint* end : {&trace.from, &trace.to}) {
        low = low.cwiseMin(end->nearest());
        high = high.cwiseMax(end->nearest());
      }
    }
    // As many boxes of joints as there are traces, at most, and one for each joint.
    const auto traces = static_cast<double>(traces_.size()),
               joints = static_cast<double>(joints_.size());
    const double longest =
        std::max(sum / traces, (high - low).sum() * joints / (traces + joints));
    const RoundUpwards upwards;
    constexpr double whole = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < traces_.size(); ++i) {
      progress.count(0, 1);
      exact::add_boxes(traces_[i].from, traces_[i].to, low, high, whole, i, probes);
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      progress.count(0, 1);
      exact::add_boxes(joints_[i].from, joints_[i].to, low, high, longest, i, boxes);
    }
  }

  void test(std::size_t number, std::size_t joint) {
    const RoundUpwards upwards;
    const JointSegment& trace = traces_[number];
    const Enclosure p = exact::enclosure(trace.from),
                    along = exact::enclosure(trace.to) - p,
                    from = exact::enclosure(joints_[joint].from) - p,
                    to = exact::enclosure(joints_[joint].to) - p;
    const Interval left = exact::cross(along, from), right = exact::cross(along, to);
    const auto side = exact::certain_sign(left), other = exact::certain_sign(right);
    if (side && other && *side * *other > 0)
      return;
    if (side && other && *side * *other < 0) {
      const Interval s = exact::cross(from, to) / (right - left);
      if (s.sup() < 0.0 || s.inf() > 1.0)
        return;
      if (s.inf() > 0.0 && s.sup() < 1.0 && (s.sup() < 0.5 || s.inf() > 0.5))
        return end_at({joint, s}, s.sup() < 0.5, number);
    }
    if (const auto s = meet(trace, joints_[joint]))
      end_at({joint, exact::around(exact::nearest(*s))}, 2 * *s <= 1, number);
  }

  // A meet before the middle, or in it, is a new begin if it is after the present one.
  void end_at(const Meet& here, bool is_before, std::size_t number) {
    std::optional<Meet>& now = is_before ? parts_[number].begin : parts_[number].end;
    if (now && is_nearer(*now, here, is_before, number))
      return;
    now = here;
  }
  bool is_nearer(const Meet& now, const Meet& here, bool is_before,
                 std::size_t number) const {
    if (const auto order = exact::certain_order(now.s, here.s); order && *order != 0)
      return (*order > 0) == is_before;
    if (now.joint == here.joint)
      return true;
    const Rational s = *meet(traces_[number], joints_[now.joint]),
                   t = *meet(traces_[number], joints_[here.joint]);
    return is_before ? s >= t : s <= t;
  }

  ExactPoint place(std::size_t number, const Meet& here) const {
    const Point start = exact::point_of(traces_[number].from);
    const Rational s = *meet(traces_[number], joints_[here.joint]);
    return exact::exact_point(start +
                              (exact::point_of(traces_[number].to) - start) * s);
  }

  const std::vector<JointSegment>&traces_, &joints_;
  std::vector<Part> parts_;
};

}  // namespace

std::vector<JointSegment> ended_at(const std::vector<JointSegment>& traces,
                                   const std::vector<JointSegment>& joints,
                                   const ProgressFunction& progress) {
  const RoundToNearest mode;
  return Ender(traces, joints).run(progress);
}

}  // namespace blocks::geometry
