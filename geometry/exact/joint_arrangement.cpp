#include "geometry/exact/joint_arrangement.hpp"

#include <algorithm>
#include <utility>

#include "geometry/exact/joint_pieces.hpp"

namespace blocks::geometry::exact {
namespace {

constexpr auto at = CutGraph::at;

// Builds the graph from the vertices of the sweep, in their order.
class GraphMaker {
 public:
  GraphMaker(const JointPieces& given, int sides, JointArrangement& result)
      : given_(given), sides_(sides), graph_(result.graph), points_(result.points),
        lines_(result.lines), states_(given.pieces.size()) {}

  void add(const SweepVertex& here) {
    const auto number = static_cast<int>(graph_.vertices.size());
    from_left_.clear();
    for (auto piece = here.left.rbegin(); piece != here.left.rend(); ++piece)
      if (const int edge = states_[at(*piece)].edge; edge >= 0) {
        graph_.origin[at(2 * edge + 1)] = number;
        from_left_.push_back(2 * edge + 1);
      }
    around_.clear();
    bool inside = here.below >= 0 && states_[at(here.below)].inside_above;
    for (const int piece : here.right) {
      State& state = states_[at(piece)];
      const bool inside_below = inside;
      inside = inside != given_.pieces[at(piece)].outline;
      state = {-1, inside};
      if (inside || inside_below) {
        state.edge = add_edge(given_.pieces[at(piece)], number);
        graph_.cell.insert(graph_.cell.end(), {inside ? 0 : -1, inside_below ? 0 : -1});
        around_.push_back(2 * state.edge);
      }
    }
    around_.insert(around_.end(), from_left_.begin(), from_left_.end());
    if (!around_.empty())
      add_vertex(here);
  }

 private:
  struct State {
    int edge = -1;  ///< the one that has begun last; -1: outside of the outline
    bool inside_above = false;
  };

  int add_edge(const Piece& source, int from) {
    const auto number = static_cast<int>(graph_.edges.size());
    graph_.edges.push_back({source.line, source.joint, source.outline, true});
    graph_.origin.insert(graph_.origin.end(), {from, -1});
    graph_.next.insert(graph_.next.end(), {-1, -1});
    graph_.previous.insert(graph_.previous.end(), {-1, -1});
    return number;
  }

  // around_: the half-edges that begin at the vertex, anticlockwise. The next one after
  // the twin of each is its neighbour on the right.
  void add_vertex(const SweepVertex& here) {
    CutGraph::Vertex& vertex = graph_.vertices.emplace_back();
    vertex.half_edge = around_.front();
    int right = around_.back();
    for (const int out : around_) {
      graph_.next[at(CutGraph::twin(out))] = right;
      graph_.previous[at(right)] = CutGraph::twin(out);
      right = out;
    }
    for (const std::vector<int>* pieces : {&here.right, &here.left})
      for (const int piece : *pieces)
        describe(given_.pieces[at(piece)], vertex);
    if (here.end < 0) {
      place_.set(lines_[at(vertex.first)], lines_[at(vertex.second)]);
      vertex.place = place_.nearest();  // exact steps only, so any rounding will do
      return;
    }
    vertex.place = given_.ends[at(here.end)].nearest();
    // Other vertices with one line are pruned.
    if (vertex.second < 0 && here.left.size() + here.right.size() > 1) {
      vertex.point = static_cast<int>(points_.size());
      points_.push_back(given_.ends[at(here.end)]);
    }
  }

  void describe(const Piece& source, CutGraph::Vertex& vertex) const {
    if (source.outline) {
      const int side = source.line;
      if (vertex.side >= 0 && vertex.side != side)
        vertex.corner = (side + 1) % sides_ == vertex.side ? vertex.side : side;
      vertex.side = vertex.side < 0 ? side : std::min(vertex.side, side);
    }
    if (vertex.first < 0)
      vertex.first = source.line;
    else if (vertex.second < 0 && source.line != vertex.first &&
             !lines_.are_parallel(at(source.line), at(vertex.first)))
      vertex.second = source.line;
  }

  const JointPieces& given_;
  int sides_;
  CutGraph& graph_;
  std::vector<ExactPoint>& points_;
  const Lines& lines_;
  std::vector<State> states_;            ///< of each piece
  std::vector<int> around_, from_left_;  ///< half-edges
  Place place_;
};

}  // namespace

JointArrangement arrange_joints(const std::vector<Point>& outline,
                                const std::vector<JointSegment>& joints,
                                const ProgressFunction& progress) {
  JointArrangement result;
  StepProgress reading(progress, "arrange joints", 0.0, 0.1);
  JointPieces given = joint_pieces(outline, joints, reading);
  result.lines = std::move(given.lines);
  StepProgress sweeping(progress, "arrange joints", 0.1, 0.6);
  GraphMaker maker(given, static_cast<int>(outline.size()), result);
  sweep_pieces(
      given.ends, given.pieces, result.lines,
      [&maker](const SweepVertex& vertex) { maker.add(vertex); }, sweeping);
  return result;
}

}  // namespace blocks::geometry::exact
