// What the steps of cutting a domain did, in numbers.
#pragma once

namespace blocks::geometry {

struct CutCounts {
  // The arrangement inside the outline, before anything is removed. Its edges include
  // those of the outline.
  long vertices = 0, edges = 0, faces = 0, components = 0;
  double p21_before = 0.0;     ///< [1/L] drawn length per area of the outline
  double p21_after = 0.0;      ///< [1/L] likewise after pruning, before cleaning
  long islands = 0;            ///< components with cells, apart from the outline
  long pinched_loops = 0;      ///< loops that meet the rest in one vertex only
  long absorbed_faces = 0;     ///< faces of islands and of pinched loops
  long straight_vertices = 0;  ///< vertices of degree two that were removed
  // Cleaning.
  long contractions = 0;        ///< edges shorter than emin, and edges of length 0
  long kept_short = 0;          ///< sides of blocks below emin that remain
  long merges = 0;              ///< cells that were merged into a neighbour
  long kept_small = 0;          ///< cells below amin that could not be merged
  double largest_move = 0.0;    ///< [L] of a vertex by contraction
  double repaired_below = 0.0;  ///< [L] used instead of emin, see cut_outline; or 0
  // The blocks.
  long t_vertices = 0;        ///< vertices inside a straight side of one cell
  long moved_t_vertices = 0;  ///< T vertices that were moved off the side
  long kept_t_vertices = 0;   ///< T vertices that remain corners of both sides
  long x_vertices = 0;        ///< other inner vertices of degree four or more
};

}  // namespace blocks::geometry
