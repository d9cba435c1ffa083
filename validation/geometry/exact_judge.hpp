// An independent judge of meshes. It uses brute force on whole numbers (boost cpp_int)
// and shares neither code nor reasoning with the certificate.
#pragma once

#include <array>
#include <string>

#include "geometry/tiling.hpp"

namespace blocks::validation {

/// The result of brute force.
struct Judgement {
  bool tiles =
      false;  ///< cells and outline are simple and clockwise, cells are disjoint
              ///< and inside the outline, and their areas add up to its area
  bool conforming = false;  ///< no corner is inside an edge, no two corners coincide
  std::string reason;       ///< the first fault found, empty if both hold
};

/// Judges by the definition, with n^2 exact comparisons. It tests every pair of edges
/// of a cell, every pair of cells, every cell against every edge of the outline, and
/// the areas. Cells are tested by separating lines of their triangles. Coordinates are
/// first scaled to whole numbers.
Judgement judge(const geometry::Mesh& mesh);

/// Is every vertex of the layer within the lines through its four corners? The corners
/// are bottom left, top left, top right, bottom right.
bool within_corners(const geometry::Mesh& mesh,
                    const std::array<geometry::Vec2, 4>& corners);

}  // namespace blocks::validation
