// PRIVATE to geometry/: prepares joints for the arrangement. CGAL's sweep takes cubic
// time where many curves overlap, and its filters fail where products overflow.
#pragma once

#include <vector>

#include "geometry/cut.hpp"
#include "geometry/exact/kernels.hpp"
#include "geometry/exact/line.hpp"

namespace blocks::geometry::exact {

/// Returns the joint id where joints overlap: the smallest one that is not 0.
int common_joint(int a, int b);

/// A part of a joint, with the line of one of the joints that contain it.
struct JointPiece {
  Point from, to;
  int joint = 0;
  Line line;
};

/// Returns pieces that cover the joints and meet in points only. Every end of a joint
/// is an end of pieces. Parts beyond four times the largest coordinate are left out,
/// and so are joints of length 0.
std::vector<JointPiece> joint_pieces(const std::vector<JointSegment>& joints);

}  // namespace blocks::geometry::exact
