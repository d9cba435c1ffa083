// Remembers which cells of a cut domain are valid, and tests changes of valid cells
// without the pairs of sides that do not change. Part of cut.cpp.
#pragma once

#include <vector>

#include "geometry/cut_graph.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {

/// A cell is valid if its rounded outline is simple and clockwise. The result of each
/// test is that of check_outline for the whole changed cell.
class CellValidity {
 public:
  /// Remembers the graph, whose cells have numbers. Report each change of a cell.
  explicit CellValidity(const CutGraph& graph) : graph_(graph) {}

  /// Tests the cell of the half-edge, unless the result is known.
  bool is_valid(int half_edge);
  /// The cell has changed in another way than those below.
  void forget(int cell) { state(cell) = State::unknown; }
  /// The cell is valid after a change.
  void set_valid(int cell) { state(cell) = State::valid; }

  /// Tests whether a valid cell, which must not vanish, remains valid if the origin of
  /// its half-edge moves to vertex u. If u is the other end of a side there, the side
  /// vanishes. False if u is another vertex of the cell.
  bool remains_valid(int half_edge, int u) const;

  /// Tests whether two valid cells become one that is valid. Their common chain leads
  /// from half-edge `into` to half-edge `out` of one of them. Requires that the chain
  /// has two different ends, and three or more sides are left.
  bool merge_is_valid(int into, int out) const;

 private:
  enum class State : signed char { unknown, valid, invalid };
  State& state(int cell) {
    if (CutGraph::at(cell) >= states_.size())
      states_.resize(CutGraph::at(cell) + 1, State::unknown);
    return states_[CutGraph::at(cell)];
  }
  const Vec2& place(int v) const { return graph_.vertices[CutGraph::at(v)].place; }

  const CutGraph& graph_;
  std::vector<State> states_;  ///< of each cell
};

}  // namespace blocks::geometry
