// The tiling certificate: these rounded polygons tile that outline, or where they do
// not. See docs/theory.md. Knows nothing of decks or blocks in motion.
#pragma once

#include <string>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Cells that share vertices by index. Cells and outline are clockwise.
struct Mesh {
  std::vector<Vec2> vertices;           ///< [L], rounded once per vertex
  std::vector<std::vector<int>> cells;  ///< vertex indices of each cell
  std::vector<int> outline;             ///< vertex indices of the outline
};

/// The verdict, with the counts that back it.
struct TilingCertificate {
  bool holds = false;
  int cells = 0;           ///< simple clockwise cells, by exact predicates
  int interior_edges = 0;  ///< twin pairs found
  int outline_edges = 0;   ///< edges without twin: exactly those of the outline
  std::string fault;       ///< empty if it holds, else what fails and where
  std::vector<int> offending_cells;
};

/// Proves that the cells tile the outline: (a) every interior directed edge has its
/// twin and the others form the outline, (b) every cell is simple and clockwise, (c) so
/// is the outline. n log n. Then every interior point lies in exactly one cell.
TilingCertificate certify_tiling(const Mesh& mesh);

}  // namespace blocks::geometry
