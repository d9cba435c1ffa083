// The tiling certificate: proves that rounded polygons tile an outline, or tells where
// they do not (docs/theory.md#the-tiling-certificate). Independent of decks and of
// blocks in motion.
#pragma once

#include <string>
#include <vector>

#include "geometry/step_progress.hpp"
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
  int interior_edges = 0;  ///< pairs of opposite directed edges
  int outline_edges = 0;   ///< edges without a twin; exactly those of the outline
  std::string fault;       ///< empty if it holds, otherwise what fails and where
  std::vector<int> offending_cells;
};

/// Proves that the cells tile the outline, so that every interior point lies in exactly
/// one cell. It checks that (a) every interior directed edge has its twin and the
/// others form the outline, (b) every cell is simple and clockwise, and (c) the outline
/// is simple and clockwise. Takes O(n log n) time. progress: may be null.
TilingCertificate certify_tiling(const Mesh& mesh, StepProgress* progress = nullptr);

}  // namespace blocks::geometry
