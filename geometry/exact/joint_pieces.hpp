// PRIVATE to geometry/: prepares the outline and its joints for the sweep, which takes
// segments that meet in points only.
#pragma once

#include <vector>

#include "geometry/cut.hpp"
#include "geometry/exact/kernels.hpp"
#include "geometry/exact/line.hpp"
#include "geometry/exact/segment_sweep.hpp"
#include "geometry/step_progress.hpp"

namespace blocks::geometry::exact {

struct JointPieces {
  std::vector<ExactPoint> ends;  ///< of the pieces, different, ascending in x, then y
  std::vector<Piece> pieces;     ///< ascending by their first ends
  Lines lines;                   ///< first the sides of the outline, then the joints
};

/// Returns pieces that cover the outline and the joints and meet in points only. Every
/// end of a side or a joint is an end of pieces. The line of a piece of the outline is
/// that of its side. Where joints overlap, the smallest id that is not 0 counts; where
/// they are on the outline, 0. Parts beyond four times the largest coordinate are left
/// out, and so are joints of length 0.
JointPieces joint_pieces(const std::vector<Point>& outline,
                         const std::vector<JointSegment>& joints,
                         StepProgress& progress);

}  // namespace blocks::geometry::exact
