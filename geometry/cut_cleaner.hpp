// PRIVATE to cut_cleaning.cpp: contracts edges (cut_contraction.cpp) and merges cells
// (cut_merging.cpp) of a graph.
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "geometry/cut_cleaning.hpp"
#include "geometry/cut_validity.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {

/// The graph must outlive the cleaner, and its cells have numbers.
class CutCleaner {
 public:
  /// repair: as in CleaningLimits.
  CutCleaner(CutGraph& graph, const exact::Lines& lines, double repair,
             CutReport& report, StepProgress& progress)
      : graph_(graph), lines_(lines), repair_(repair), report_(report),
        progress_(progress), validity_(graph) {}

  /// Contracts edges shorter than emin, and those of length 0, the shortest first.
  void contract_below(double emin);
  /// Merges cells smaller than amin, and those that are not valid.
  void merge_below(double amin);
  /// Makes two vertices at one place one vertex, so that a cell that rounding has
  /// pinched becomes two, or loses a spike. Returns whether there were any.
  bool identify_coinciding_vertices();
  /// Removes vertices with two collinear edges, which contraction may leave.
  void join_straight_edges();

 private:
  using Key = std::tuple<double, int, int, int>;  // squared length, ends, edge

  Polygon clockwise(const std::vector<int>& loop) const {
    Polygon polygon;
    for (auto v = loop.rbegin(); v != loop.rend(); ++v)
      polygon.push_back(graph_.vertices[CutGraph::at(*v)].place);
    return polygon;
  }
  std::vector<int> loop_of(int half_edge) const {
    std::vector<int> loop;
    for (int h = half_edge;;) {
      loop.push_back(graph_.origin[CutGraph::at(h)]);
      h = graph_.next[CutGraph::at(h)];
      if (h == half_edge)
        return loop;
    }
  }
  bool valid(const std::vector<int>& loop) const {
    const OutlineCheck check = check_outline(clockwise(loop));
    return check.fault == OutlineFault::none && !check.anticlockwise;
  }
  static bool has_distinct_vertices(std::vector<int> loop) {
    std::sort(loop.begin(), loop.end());
    return std::adjacent_find(loop.begin(), loop.end()) == loop.end();
  }
  Key key(int e) const {
    const int a = graph_.origin[2 * CutGraph::at(e)],
              b = graph_.origin[2 * CutGraph::at(e) + 1];
    const Vec2 d =
        graph_.vertices[CutGraph::at(a)].place - graph_.vertices[CutGraph::at(b)].place;
    return {d.squaredNorm(), std::min(a, b), std::max(a, b), e};
  }
  // Rank of a vertex: a corner of the outline remains before a vertex on the outline,
  // which remains before an inner vertex.
  int rank(int v) const {
    const auto& vertex = graph_.vertices[CutGraph::at(v)];
    return vertex.corner >= 0 ? 2 : vertex.side >= 0 ? 1 : 0;
  }
  bool try_contract(int e);
  bool has_only_cells_between(int half_edge) const;
  bool may_change_bad_cell(int half_edge, int u) const;
  bool may_move(int half_edge);
  /// Whether protection keeps the origin of the half-edge from moving to its target.
  bool is_held(int half_edge) const;
  void contract(int half_edge);
  void remove_digon(int half_edge);
  bool lies_on(const CutGraph::Vertex& vertex, int line) const;
  bool try_identify(int half_edge, int other);
  void find_first_half_edges();
  bool try_merge(int cell);
  void join_if_straight(int vertex);

  CutGraph& graph_;
  const exact::Lines& lines_;
  double repair_;  ///< [L] longest edge that moves a protected vertex
  CutReport& report_;
  StepProgress& progress_;
  CellValidity validity_;
  std::vector<int> first_;      ///< a half-edge of each cell; -1: no longer a cell
  int cells_ = 0;               ///< number of the next new cell; 0: not known yet
  std::vector<int> changed_;    ///< cells that the last merge has changed
  std::vector<int> destroyed_;  ///< a half-edge of each cell that is still not valid
};

}  // namespace blocks::geometry
