// The plane graph of outline and joints as half-edges in arrays, and the removal of
// what does not separate cells. Part of cut.cpp; independent of CGAL.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "geometry/cut.hpp"
#include "geometry/step_progress.hpp"
#include "geometry/vec2.hpp"

namespace blocks::geometry {

/// Half-edges 2e and 2e + 1 are the two directions of edge e. A cell is on the left of
/// its half-edges; `next` turns around the cell anticlockwise.
class CutGraph {
 public:
  struct Edge {
    int line = -1;  ///< segment whose line contains the edge; -1: moved off it
    int joint = 0;  ///< joint id
    bool outline = false;
    bool alive = true;
    bool is_protected = false;  ///< no merge removes it
  };
  struct Vertex {
    Vec2 place = Vec2::Zero();    ///< [L]
    int first = -1, second = -1;  ///< segments with different lines through it; or -1
    int point = -1;               ///< exact place, if needed and no second line; or -1
    int half_edge = -1;           ///< one that begins here; -1: none is left
    int corner = -1;              ///< corner of the outline, from 0; -1: none
    int side = -1;                ///< side of the outline that contains it; -1: none
    bool is_protected = false;    ///< no contraction moves it
  };
  std::vector<Edge> edges;
  std::vector<Vertex> vertices;
  std::vector<int> origin, next, previous;  ///< of each half-edge
  std::vector<int> cell;  ///< of each half-edge; -1: outside of the outline

  static int twin(int half_edge) { return half_edge ^ 1; }
  int target(int half_edge) const { return origin[at(twin(half_edge))]; }
  Edge& edge(int half_edge) { return edges[at(half_edge) / 2]; }
  const Edge& edge(int half_edge) const { return edges[at(half_edge) / 2]; }
  bool alive(int half_edge) const { return edge(half_edge).alive; }
  int half_edges() const { return static_cast<int>(origin.size()); }
  Vertex& from(int half_edge) { return vertices[at(origin[at(half_edge)])]; }
  const Vertex& from(int half_edge) const {
    return vertices[at(origin[at(half_edge)])];
  }
  double length(std::size_t e) const {
    return (vertices[at(origin[2 * e])].place - vertices[at(origin[2 * e + 1])].place)
        .norm();
  }

  /// Removes the edge from both of its ends. Cells are not changed.
  void remove_edge(std::size_t e);
  /// Removes a vertex of degree two by joining its two edges; returns the edge that
  /// remains.
  int join_edges(int vertex);
  /// Number of edges at the vertex.
  int degree(int vertex) const;
  /// Numbers the cells; -1 outside of the outline. Requires that the graph is
  /// connected.
  void number_cells(StepProgress& progress);

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
};

/// Removes all edges that are not on a common simple cycle with an edge of the outline:
/// dangling ends, islands, and loops that meet the rest in one vertex. In what remains,
/// every face is bounded by one simple cycle. Fills the counts of the report.
void keep_separating_edges(CutGraph& graph, CutReport& report, StepProgress& progress);

}  // namespace blocks::geometry
