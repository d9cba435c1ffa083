// PRIVATE to geometry/: rounds the vertices of an exact arrangement, each one once.
// Part of cut.cpp.
#pragma once

#include <vector>

#include "geometry/cut_graph.hpp"
#include "geometry/exact/joint_arrangement.hpp"
#include "geometry/step_progress.hpp"

namespace blocks::geometry {

/// Returns the graph with rounded vertices, in order of their places,
/// and of their exact places where these are equal. So numbers of vertices and edges do
/// not depend on the order of the joints. Vertices become the nearest doubles. On
/// slanted sides of the outline they are rounded towards the domain, as those of
/// layers. corners: of the outline, in doubles.
CutGraph round_vertices(const exact::JointArrangement& arrangement,
                        const std::vector<exact::Point>& outline,
                        const std::vector<Vec2>& corners, StepProgress progress);

}  // namespace blocks::geometry
