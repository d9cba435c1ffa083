// A map of fracture traces: polylines and the window in which they were mapped.
#pragma once

#include <string>
#include <vector>

#include "geometry/cut.hpp"

namespace blocks::joints {

/// Traces as they were mapped or generated, and the window that was mapped.
struct TraceMap {
  std::string name;                            ///< for tables and messages
  std::vector<geometry::DecimalPoint> window;  ///< [L] simple and clockwise
  /// Straight pieces of all traces. The id of a piece is the number of its trace, from
  /// 1; the pieces of a polyline follow each other.
  std::vector<geometry::JointSegment> segments;
  int traces = 0;  ///< number of traces, the largest id
  /// [L] >= 0: an end that overshoots another trace by at most this is an end drawn too
  /// far, and no crossing.
  double snap = 0.0;
};

/// Returns the bounding box of all traces as a window. Throws std::runtime_error if it
/// has no area.
std::vector<geometry::DecimalPoint>
box_window(const std::vector<geometry::JointSegment>& segments);

/// Prolongs ends that stop short of another trace, by at most `snap` [L] along their
/// trace, to it exactly (geometry::prolonged), and sets TraceMap::snap. Returns the
/// number of prolonged ends.
std::size_t close_gaps(TraceMap& map, const geometry::Decimal& snap);

}  // namespace blocks::joints
