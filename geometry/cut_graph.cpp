#include "geometry/cut_graph.hpp"

#include <algorithm>
#include <numeric>

namespace blocks::geometry {
namespace {

constexpr auto at = CutGraph::at;

// Finds the biconnected components of the vertices that are connected to a root, by
// Tarjan's depth-first search with an explicit stack.
class Biconnected {
 public:
  Biconnected(const CutGraph& graph, StepProgress& progress)
      : graph_(graph), progress_(progress), found_(graph.vertices.size(), 0),
        low_(graph.vertices.size(), 0), component_(graph.edges.size(), -1) {}

  /// Searches from the origin of the half-edge, which is the first to be followed.
  void search(int half_edge) {
    const int root = graph_.origin[at(half_edge)];
    open(root, -1, half_edge);
    while (!stack_.empty()) {
      progress_.count(0, 1);
      Visit& visit = stack_.back();
      if (visit.next < 0) {
        close();
        continue;
      }
      const int out = visit.next;
      const int after = graph_.next[at(CutGraph::twin(out))];
      visit.next = after == visit.first ? -1 : after;
      const int from = graph_.origin[at(out)], to = graph_.target(out);
      if (out == CutGraph::twin(visit.entry))
        continue;
      if (found_[at(to)] == 0) {
        pending_.push_back(out / 2);
        open(to, out, CutGraph::twin(out));
      } else if (found_[at(to)] < found_[at(from)]) {
        pending_.push_back(out / 2);
        low_[at(from)] = std::min(low_[at(from)], found_[at(to)]);
      }
    }
  }
  bool found(int vertex) const { return found_[at(vertex)] > 0; }
  /// Component of the edge, from 0 in the order of completion.
  int component(std::size_t e) const { return component_[e]; }
  int components() const { return components_; }

 private:
  struct Visit {
    int entry;  ///< half-edge that leads to the vertex; -1: root
    int first;  ///< first half-edge out of the vertex
    int next;   ///< next half-edge to follow; -1: none
  };
  void open(int vertex, int entry, int first) {
    found_[at(vertex)] = low_[at(vertex)] = ++time_;
    stack_.push_back({entry, first, first});
  }
  void close() {
    const int entry = stack_.back().entry;
    stack_.pop_back();
    if (entry < 0)
      return;
    const int parent = graph_.origin[at(entry)], child = graph_.target(entry);
    low_[at(parent)] = std::min(low_[at(parent)], low_[at(child)]);
    if (low_[at(child)] < found_[at(parent)])
      return;
    for (int last = -1; last != entry / 2;) {
      last = pending_.back();
      pending_.pop_back();
      component_[at(last)] = components_;
    }
    ++components_;
  }

  const CutGraph& graph_;
  StepProgress& progress_;
  std::vector<int> found_, low_;  ///< time of discovery; 0: not yet
  std::vector<int> component_;
  std::vector<int> pending_;
  std::vector<Visit> stack_;
  int time_ = 0, components_ = 0;
};

}  // namespace

void CutGraph::remove_edge(std::size_t e) {
  for (const std::size_t h : {2 * e, 2 * e + 1}) {
    const int into = previous[h], out = next[h ^ 1U];
    const bool last = out == static_cast<int>(h);
    Vertex& vertex = vertices[at(origin[h])];
    if (!last) {
      next[at(into)] = out;
      previous[at(out)] = into;
    }
    if (vertex.half_edge == static_cast<int>(h))
      vertex.half_edge = last ? -1 : out;
  }
  edges[e].alive = false;
}

int CutGraph::join_edges(int vertex) {
  // a -> vertex -> b becomes a -> b; the second edge is removed.
  const int out = vertices[at(vertex)].half_edge, back = twin(out);
  const int into = previous[at(out)], away = twin(into);
  const int last = target(out);
  next[at(into)] = next[at(out)];
  previous[at(next[at(out)])] = into;
  previous[at(away)] = previous[at(back)];
  next[at(previous[at(back)])] = away;
  origin[at(away)] = last;
  if (vertices[at(last)].half_edge == back)
    vertices[at(last)].half_edge = away;
  vertices[at(vertex)].half_edge = -1;
  edge(out).alive = false;
  return into / 2;
}

int CutGraph::degree(int vertex) const {
  const int first = vertices[at(vertex)].half_edge;
  int count = 0;
  for (int h = first; h >= 0;) {
    ++count;
    h = next[at(twin(h))];
    if (h == first)
      break;
  }
  return count;
}

void CutGraph::number_cells(StepProgress& progress) {
  constexpr int unknown = -2;
  const std::vector<int> before = cell;
  cell.assign(origin.size(), unknown);
  int count = 0;
  for (int h = 0; h < half_edges(); ++h) {
    progress.count(1, 1);
    if (!alive(h) || cell[at(h)] != unknown)
      continue;
    const int number = before[at(h)] < 0 ? -1 : count++;
    int turn = h;
    do {
      cell[at(turn)] = number;
      turn = next[at(turn)];
    } while (turn != h);
  }
}

void keep_separating_edges(CutGraph& graph, CutReport& report, StepProgress& progress) {
  const auto vertices = static_cast<int>(graph.vertices.size());
  int start = 0;
  while (!graph.alive(start) || !graph.edge(start).outline)
    ++start;
  Biconnected search(graph, progress);
  search.search(start);
  const int kept = search.component(at(start) / 2);
  const int connected = search.components();
  int parts = 1;
  std::vector<std::size_t> first_of_part;  // first component of each island
  std::vector<int> island_of;              // of each component after `connected`
  for (int v = 0; v < vertices; ++v) {
    progress.count(1, 1);
    if (graph.vertices[at(v)].half_edge >= 0 && !search.found(v)) {
      search.search(graph.vertices[at(v)].half_edge);
      island_of.resize(at(search.components() - connected), parts);
      ++parts;
    }
  }
  report.components = parts;

  std::vector<int> size(at(search.components()), 0);
  long edges = 0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    if (graph.edges[e].alive) {
      ++size[at(search.component(e))];
      ++edges;
    }
  std::vector<bool> has_cells(at(parts), false);
  for (int c = 0; c < search.components(); ++c) {
    if (size[at(c)] == 1 || c == kept)
      continue;
    if (c < connected)
      ++report.pinched_loops;
    else
      has_cells[at(island_of[at(c - connected)])] = true;
  }
  report.islands = std::count(has_cells.begin(), has_cells.end(), true);
  const auto left = [&] {
    return std::count_if(graph.vertices.begin(), graph.vertices.end(),
                         [](const auto& v) { return v.half_edge >= 0; });
  };
  report.vertices = left();
  report.edges = edges;
  report.faces = edges + parts - report.vertices;  // Euler's formula, inner faces
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    progress.count(1, 1);
    if (!graph.edges[e].alive || search.component(e) == kept)
      continue;
    ++report.pruned_edges;
    graph.remove_edge(e);
  }
  const long remain = edges - report.pruned_edges;
  report.absorbed_faces = report.faces - (remain + 1 - left());
}

}  // namespace blocks::geometry
