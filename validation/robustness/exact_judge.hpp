// An independent judge of meshes: brute force on whole numbers (boost cpp_int), sharing
// no line of code and no argument with the certificate.
#pragma once

#include <array>
#include <string>

#include "geometry/tiling.hpp"

namespace blocks::robustness {

/// What brute force finds.
struct Judgement {
  bool tiles = false;  ///< cells and outline simple and clockwise, cells disjoint and
                       ///< inside the outline, areas add up: their union is the outline
  bool conforming = false;  ///< no corner inside an edge, no two corners at one place
  std::string reason;       ///< the first thing found wrong, empty if both hold
};

/// Judges by definition, in n^2 exact comparisons: every pair of edges of a cell, every
/// pair of cells (by the separating lines of their triangles), every cell against every
/// edge of the outline, and the areas. Coordinates are scaled to whole numbers first.
Judgement judge(const geometry::Mesh& mesh);

/// No vertex of the layer lies beyond the lines through its four corners, and these are
/// given: bottom left, top left, top right, bottom right.
bool within_corners(const geometry::Mesh& mesh,
                    const std::array<geometry::Vec2, 4>& corners);

}  // namespace blocks::robustness
