// Changes of valid cells: the tests of changed sides agree with that of the whole cell.
#include "geometry/cut_validity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace blocks::geometry {
namespace {

using Loop = std::vector<int>;

// Cells of given vertices, anticlockwise.
CutGraph graph_of(const std::vector<Vec2>& places, const std::vector<Loop>& cells) {
  CutGraph graph;
  for (const Vec2& place : places)
    graph.vertices.emplace_back().place = place;
  std::map<std::pair<int, int>, int> half_edges;
  const auto half_edge = [&](int v, int w) {
    const auto found = half_edges.find({v, w});
    if (found != half_edges.end())
      return found->second;
    const auto h = static_cast<int>(graph.origin.size());
    half_edges[{v, w}] = h;
    half_edges[{w, v}] = h + 1;
    graph.edges.emplace_back();
    graph.origin.insert(graph.origin.end(), {v, w});
    for (auto* list : {&graph.next, &graph.previous, &graph.cell})
      list->insert(list->end(), 2, -1);
    return h;
  };
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t i = 0; i < cells[c].size(); ++i) {
      const std::size_t n = cells[c].size();
      const int h = half_edge(cells[c][i], cells[c][(i + 1) % n]);
      const int after = half_edge(cells[c][(i + 1) % n], cells[c][(i + 2) % n]);
      graph.cell[CutGraph::at(h)] = static_cast<int>(c);
      graph.next[CutGraph::at(h)] = after;
      graph.previous[CutGraph::at(after)] = h;
    }
  return graph;
}

bool is_valid(const std::vector<Vec2>& places, const Loop& anticlockwise) {
  Polygon clockwise;
  for (auto v = anticlockwise.rbegin(); v != anticlockwise.rend(); ++v)
    clockwise.push_back(places[CutGraph::at(*v)]);
  const OutlineCheck check = check_outline(clockwise);
  return check.fault == OutlineFault::none && !check.anticlockwise;
}

// Points of a coarse grid, so that many sides touch, overlap or are collinear.
std::vector<Vec2> grid_points(std::mt19937& random, int count, unsigned size) {
  std::vector<Vec2> places;
  for (int i = 0; i < count; ++i)
    places.emplace_back(random() % size, random() % size);
  return places;
}

int half_edge_from(const CutGraph& graph, int v, int cell) {
  for (int h = 0; h < graph.half_edges(); ++h)
    if (graph.origin[CutGraph::at(h)] == v && graph.cell[CutGraph::at(h)] == cell)
      return h;
  return -1;
}

TEST(CellValidity, MovesAgreeWithTheTestOfTheWholeCell) {
  std::mt19937 random(1);
  int moves = 0, valid = 0;
  for (int i = 0; i < 200000; ++i) {
    const int n = 3 + static_cast<int>(random() % 4);
    const std::vector<Vec2> places = grid_points(random, n + 1, 5);
    Loop loop;
    for (int v = 0; v < n; ++v)
      loop.push_back(v);
    if (!is_valid(places, loop))
      continue;
    const CutGraph graph = graph_of(places, {loop});
    for (const int u : {n, 1, n - 1}) {  // another vertex, and both neighbours of 0
      Loop moved = loop;
      moved[0] = u;
      moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
      if (moved.front() == moved.back())
        moved.pop_back();
      if (moved.size() < 3)
        continue;
      const bool expected = is_valid(places, moved);
      EXPECT_EQ(CellValidity(graph).remains_valid(half_edge_from(graph, 0, 0), u),
                expected);
      ++moves;
      valid += expected ? 1 : 0;
    }
  }
  EXPECT_GT(valid, 1000);
  EXPECT_GT(moves - valid, 1000);
}

// Cells 0 ... a ... b and b ... a ... 0 with a chain of one or two sides between them.
TEST(CellValidity, MergesAgreeWithTheTestOfTheWholeCell) {
  std::mt19937 random(2);
  int merges = 0, valid = 0;
  for (int i = 0; i < 1000000; ++i) {
    const int left = static_cast<int>(random() % 3),
              right = static_cast<int>(random() % 3);
    const int inner = static_cast<int>(random() % 2);  // vertices inside the chain
    if (left + right < 1 || left + inner < 1 || right + inner < 1)
      continue;
    const std::vector<Vec2> places = grid_points(random, 2 + inner + left + right, 4);
    // The chain leads from vertex 0 to vertex 1.
    Loop one = {0}, other = {1}, both = {1};
    if (inner > 0) {
      one.push_back(2);
      other.push_back(2);
    }
    one.push_back(1);
    other.push_back(0);
    for (int v = 0; v < left; ++v) {
      one.push_back(2 + inner + v);
      both.push_back(one.back());
    }
    both.push_back(0);
    for (int v = 0; v < right; ++v) {
      other.push_back(2 + inner + left + v);
      both.push_back(other.back());
    }
    if (!is_valid(places, one) || !is_valid(places, other))
      continue;
    const CutGraph graph = graph_of(places, {one, other});
    const int into = half_edge_from(graph, 0, 0);
    const int out = inner > 0 ? half_edge_from(graph, 2, 0) : into;
    const bool expected = is_valid(places, both);
    EXPECT_EQ(CellValidity(graph).merge_is_valid(into, out), expected);
    ++merges;
    valid += expected ? 1 : 0;
  }
  EXPECT_GT(valid, 1000);
  EXPECT_GT(merges - valid, 500);
}

}  // namespace
}  // namespace blocks::geometry
