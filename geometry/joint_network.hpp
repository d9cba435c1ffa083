// Measures the network of joints that blocks at rest form: its length and its vertices.
// A report for the user, independent of contacts.
#pragma once

#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// A joint is the segment along which edges of two blocks touch. Edges touch, and
/// corners meet, if their distance is at most 4 units in the last place of the largest
/// coordinate (rounding_units in rounding.hpp), because blocks of two layers on one
/// slanted line are rounded differently.
///
/// Corners of different blocks that meet form one vertex.
struct JointNetwork {
  double length = 0.0;  ///< [L] of all joints; a joint of two blocks counts once
  /// Vertices inside an edge of another block, so that a joint ends at this edge.
  int t_vertices = 0;
  /// Vertices where at least four corners meet, and that are not T vertices.
  int x_vertices = 0;
};

/// Measures the joints between all outlines. outlines: simple and clockwise, [L]; empty
/// ones are ignored. Guarantees: the counts do not depend on the order of the outlines,
/// and the length depends on it by round-off only. The result is the same in every
/// call. Takes O(n log n) time for n blocks of similar size.
JointNetwork find_joint_network(const std::vector<Polygon>& outlines);

}  // namespace blocks::geometry
