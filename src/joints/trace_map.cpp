#include "joints/trace_map.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "geometry/joint_sources.hpp"

namespace blocks::joints {

using geometry::Decimal;
using geometry::DecimalPoint;
using geometry::JointSegment;
using geometry::Vec2;

std::vector<DecimalPoint> box_window(const std::vector<JointSegment>& segments) {
  Vec2 low = Vec2::Constant(HUGE_VAL), high = -low;
  for (const JointSegment& one : segments)
    for (const Vec2& end : {one.from.nearest(), one.to.nearest()}) {
      low = low.cwiseMin(end);
      high = high.cwiseMax(end);
    }
  if (!((high - low).minCoeff() > 0.0))
    throw std::runtime_error("the box of the traces has no area, so there is no window "
                             "for them\n  hint: give the window with --outline FILE");
  const auto point = [](double x, double y) {
    return DecimalPoint{*Decimal::parse(fmt::format("{}", x)),
                        *Decimal::parse(fmt::format("{}", y))};
  };
  return {point(low.x(), low.y()), point(low.x(), high.y()), point(high.x(), high.y()),
          point(high.x(), low.y())};
}

std::size_t close_gaps(TraceMap& map, const Decimal& snap) {
  geometry::Prolongation moved =
      geometry::prolonged(map.segments, snap, {}, map.window);
  map.segments = std::move(moved.traces);
  map.snap = snap.value();
  return moved.ends;
}

}  // namespace blocks::joints
