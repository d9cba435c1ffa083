// PRIVATE to geometry/: the exact arrangement of an outline and its joints.
#pragma once

#include <vector>

#include "geometry/cut.hpp"
#include "geometry/cut_graph.hpp"
#include "geometry/exact/line.hpp"

namespace blocks::geometry::exact {

/// The graph inside the outline, and the lines of the segments: first the sides of the
/// outline, then the joints.
struct JointArrangement {
  CutGraph graph;
  Lines lines;
  std::vector<ExactPoint> points;  ///< places of vertices that have no second line
};

/// Arranges outline and joints; edges outside of the outline are left out. The places
/// of vertices are rounded to the nearest doubles. outline: simple and clockwise.
/// Joints of length 0 are ignored. The reports of progress end at part 0.6.
JointArrangement arrange_joints(const std::vector<Point>& outline,
                                const std::vector<JointSegment>& joints,
                                const ProgressFunction& progress);

}  // namespace blocks::geometry::exact
