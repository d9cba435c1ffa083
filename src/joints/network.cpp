#include "joints/network.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "geometry/polygon.hpp"
#include "geometry/trace_graph.hpp"

namespace blocks::joints {
namespace {

using geometry::TraceGraph;
using geometry::Vec2;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Disjoint sets of numbers from 0.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a), b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

class Counter {
 public:
  explicit Counter(const TraceMap& map)
      : map_(map), graph_(geometry::trace_graph(map.window, map.segments)),
        cut_(graph_.nodes.size(), false) {
    for (const geometry::DecimalPoint& corner : map.window)
      network_.window.emplace_back(corner.x.value(), corner.y.value());
    network_.area = geometry::section_properties(network_.window).area;
    cut_overshoots(map.snap);
    std::stable_sort(graph_.edges.begin(), graph_.edges.end(),
                     [](const auto& a, const auto& b) { return a.trace < b.trace; });
    edges_at_.resize(graph_.nodes.size());
    for (std::size_t e = 0; e < graph_.edges.size(); ++e)
      for (const int node : {graph_.edges[e].from, graph_.edges[e].to})
        edges_at_[at(node)].push_back(e);
  }

  Network count() {
    count_nodes();
    find_branches();
    find_pieces();
    return std::move(network_);
  }

 private:
  void cut_overshoots(double snap) {
    if (!(snap > 0.0))
      return;
    const auto is_overshoot = [&](const TraceGraph::Edge& edge) {
      const auto &p = graph_.nodes[at(edge.from)], &q = graph_.nodes[at(edge.to)];
      const auto is_end = [](const auto& end, const auto& other) {
        return end.degree == 1 && !end.on_window && other.degree >= 3;
      };
      return edge.length <= snap && (is_end(p, q) || is_end(q, p));
    };
    // All ends are judged before any is cut, so the order has no effect.
    std::vector<char> cut;
    for (const TraceGraph::Edge& edge : graph_.edges)
      cut.push_back(is_overshoot(edge));
    std::vector<TraceGraph::Edge> kept;
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      if (!cut[e]) {
        kept.push_back(graph_.edges[e]);
        continue;
      }
      ++network_.overshoots;
      for (const int node : {graph_.edges[e].from, graph_.edges[e].to}) {
        --graph_.nodes[at(node)].degree;
        cut_[at(node)] = true;
      }
    }
    graph_.edges = std::move(kept);
  }

  /// Whether branches go on through the node: a bend, or two ends that meet.
  bool is_passed(int node) const {
    return graph_.nodes[at(node)].degree == 2 && !graph_.nodes[at(node)].on_window;
  }

  void count_nodes() {
    NodeCounts& nodes = network_.nodes;
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      const TraceGraph::Node& node = graph_.nodes[n];
      if (node.on_window || node.degree == 0)
        continue;  // E nodes are counted as ends of pieces
      if (node.degree == 2) {
        const auto& edges = edges_at_[n];
        nodes.joined +=
            graph_.edges[edges[0]].trace != graph_.edges[edges[1]].trace ? 1U : 0U;
        continue;
      }
      nodes.degrees += at(node.degree);
      ++(node.degree == 1 ? nodes.i : node.degree == 3 ? nodes.y : nodes.x);
      nodes.more += node.degree > 4 ? 1U : 0U;
    }
  }

  End end_at(int node) const {
    const TraceGraph::Node& one = graph_.nodes[at(node)];
    return one.on_window     ? End::window
           : one.degree == 1 ? End::isolated
                             : End::connected;
  }

  void find_branches() {
    Sets chains(graph_.edges.size());
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n)
      if (is_passed(static_cast<int>(n)))
        chains.join(edges_at_[n][0], edges_at_[n][1]);
    std::map<std::size_t, std::pair<double, std::vector<End>>> found;
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      auto& [length, ends] = found[chains.of(e)];
      length += graph_.edges[e].length;
      for (const int node : {graph_.edges[e].from, graph_.edges[e].to})
        if (!is_passed(node))
          ends.push_back(end_at(node));
    }
    for (auto& [first, chain] : found) {
      std::sort(chain.second.begin(), chain.second.end());
      if (chain.second.size() == 2)  // a loop without nodes is no branch
        network_.branches.push_back({chain.first, chain.second[0], chain.second[1]});
    }
  }

  void find_pieces() {
    // Ends of the traces as given, to find ends that an overlap has made.
    std::map<int, std::pair<Vec2, Vec2>> given;
    for (const geometry::JointSegment& one : map_.segments) {
      const auto [where, is_new] =
          given.try_emplace(one.id, one.from.nearest(), one.to.nearest());
      where->second.second = one.to.nearest();
    }
    std::size_t begin = 0;
    while (begin < graph_.edges.size()) {
      std::size_t end = begin;
      while (end < graph_.edges.size() &&
             graph_.edges[end].trace == graph_.edges[begin].trace)
        ++end;
      find_pieces_of(begin, end, given.at(graph_.edges[begin].trace));
      begin = end;
    }
  }

  void find_pieces_of(std::size_t begin, std::size_t end,
                      const std::pair<Vec2, Vec2>& given) {
    Sets connected(end - begin);
    std::map<int, std::vector<std::size_t>> own;  // edges of the trace at each node
    for (std::size_t e = begin; e < end; ++e)
      for (const int node : {graph_.edges[e].from, graph_.edges[e].to})
        own[node].push_back(e - begin);
    for (const auto& [node, edges] : own)
      if (!graph_.nodes[at(node)].on_window)
        for (const std::size_t e : edges)
          connected.join(edges[0], e);
    std::map<std::size_t, std::size_t> piece_of;
    std::map<std::size_t, std::vector<int>> ends_of;
    for (std::size_t e = begin; e < end; ++e) {
      const TraceGraph::Edge& edge = graph_.edges[e];
      const auto [where, is_new] =
          piece_of.try_emplace(connected.of(e - begin), network_.pieces.size());
      const std::size_t piece = where->second;
      if (is_new)
        network_.pieces.emplace_back().trace = edge.trace;
      network_.pieces[piece].length += edge.length;
      network_.parts.push_back(
          {graph_.nodes[at(edge.from)].place, graph_.nodes[at(edge.to)].place, piece});
      for (const int node : {edge.from, edge.to})
        if (own[node].size() == 1 || graph_.nodes[at(node)].on_window)
          ends_of[piece].push_back(node);
    }
    for (const auto& [key, piece] : piece_of)
      describe(network_.pieces[piece], ends_of[piece], given, piece);
  }

  /// Another trace at the node; 0: none.
  int host_of(int trace, int node) const {
    for (const std::size_t e : edges_at_[at(node)])
      if (graph_.edges[e].trace != trace)
        return graph_.edges[e].trace;
    return 0;
  }

  void describe(Piece& piece, const std::vector<int>& ends,
                const std::pair<Vec2, Vec2>& given, std::size_t number) {
    for (const int end : ends) {
      const Vec2& place = graph_.nodes[at(end)].place;
      if (graph_.nodes[at(end)].on_window) {
        ++piece.hidden;
        ++network_.nodes.window;
      } else if (!cut_[at(end)] && place != given.first && place != given.second) {
        ++network_.overlaps;
      }
      if (end_at(end) == End::connected)
        piece.hosts[at(std::min(piece.connected++, 1))] = host_of(piece.trace, end);
    }
    piece.hidden = std::min(piece.hidden, 2);
    Vec2 along;
    if (ends.size() >= 2) {
      piece.from = graph_.nodes[at(ends.front())].place;
      piece.to = graph_.nodes[at(ends.back())].place;
      piece.from_hidden = graph_.nodes[at(ends.front())].on_window;
      piece.to_hidden = graph_.nodes[at(ends.back())].on_window;
      along = piece.to - piece.from;
    } else {
      piece.from = piece.to = network_.parts.back().from;
      along.setZero();
    }
    if (along.isZero())  // a loop: its longest part
      for (const Part& part : network_.parts)
        if (part.piece == number && (part.to - part.from).norm() > along.norm())
          along = part.to - part.from;
    double degrees = std::atan2(along.y(), along.x()) * 180.0 / std::numbers::pi;
    if (degrees < 0.0)
      degrees += 180.0;
    piece.direction = degrees < 180.0 ? degrees : 0.0;
  }

  const TraceMap& map_;
  TraceGraph graph_;
  std::vector<char> cut_;  ///< whether an overshoot was cut at the node
  std::vector<std::vector<std::size_t>> edges_at_;
  Network network_;
};

}  // namespace

double Network::length() const {
  double sum = 0.0;
  for (const Piece& piece : pieces)
    sum += piece.length;
  return sum;
}

Network network_of(const TraceMap& map) { return Counter(map).count(); }

}  // namespace blocks::joints
