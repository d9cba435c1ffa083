#include "geometry/cut_cleaning.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "geometry/exact/line.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

constexpr auto at = CutGraph::at;

class Cleaner {
 public:
  Cleaner(CutGraph& graph, const std::vector<exact::Line>& lines, CutReport& report,
          StepProgress& progress)
      : graph_(graph), lines_(lines), report_(report), progress_(progress) {}

  void contract_below(double emin);
  void merge_below(double amin);
  bool identify_coinciding_vertices();

 private:
  using Key = std::tuple<double, int, int, int>;  // squared length, ends, edge

  Polygon clockwise(const std::vector<int>& loop) const {
    Polygon polygon;
    for (auto v = loop.rbegin(); v != loop.rend(); ++v)
      polygon.push_back(graph_.vertices[at(*v)].place);
    return polygon;
  }
  std::vector<int> loop_of(int half_edge) const {
    std::vector<int> loop;
    for (int h = half_edge;;) {
      loop.push_back(graph_.origin[at(h)]);
      h = graph_.next[at(h)];
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
    const int a = graph_.origin[2 * at(e)], b = graph_.origin[2 * at(e) + 1];
    const Vec2 d = graph_.vertices[at(a)].place - graph_.vertices[at(b)].place;
    return {d.squaredNorm(), std::min(a, b), std::max(a, b), e};
  }
  // Rank of a vertex: a corner of the outline remains before a vertex on the outline,
  // which remains before an inner vertex.
  int rank(int v) const {
    const auto& vertex = graph_.vertices[at(v)];
    return vertex.corner >= 0 ? 2 : vertex.side >= 0 ? 1 : 0;
  }
  bool try_contract(int e);
  bool has_only_cells_between(int half_edge) const;
  bool may_move(int half_edge) const;
  void contract(int half_edge);
  void remove_digon(int half_edge);
  bool lies_on(const CutGraph::Vertex& vertex, int line) const;
  bool try_identify(int half_edge, int other);
  bool try_merge(int cell, std::map<int, int>& first);
  void join_if_straight(int vertex, std::map<int, int>& first);

  CutGraph& graph_;
  const std::vector<exact::Line>& lines_;
  CutReport& report_;
  StepProgress& progress_;
  int cells_ = 0;               ///< number of the next new cell; 0: not known yet
  std::vector<int> destroyed_;  ///< a half-edge of each cell that is still not valid
};

bool Cleaner::lies_on(const CutGraph::Vertex& vertex, int line) const {
  if (line < 0 || vertex.moved)
    return false;
  if (line == vertex.first || line == vertex.second)
    return true;
  if (vertex.first < 0 || vertex.second < 0)
    return false;
  const exact::Place p =
      exact::intersection(lines_[at(vertex.first)], lines_[at(vertex.second)]);
  const exact::Line& l = lines_[at(line)];
  return l.a * p.x + l.b * p.y + l.c * p.w == 0;
}

// Tests the link condition: the ends share no neighbours other than those of triangles
// at the edge. Otherwise contraction would make loops or fold a part of the mesh.
bool Cleaner::has_only_cells_between(int half_edge) const {
  const int u = graph_.target(half_edge), back = CutGraph::twin(half_edge);
  std::set<int> neighbours;
  int out = back;
  do {
    neighbours.insert(graph_.target(out));
    out = graph_.next[at(CutGraph::twin(out))];
  } while (out != back);
  int common = 0, triangles = 0;
  for (out = graph_.next[at(back)]; out != half_edge;
       out = graph_.next[at(CutGraph::twin(out))]) {
    if (graph_.target(out) == u)
      return false;
    common += neighbours.contains(graph_.target(out)) ? 1 : 0;
  }
  for (const int h : {half_edge, back})
    triangles += graph_.next[at(graph_.next[at(graph_.next[at(h)])])] == h ? 1 : 0;
  return common == triangles;
}

// Tests whether the origin of the half-edge may move to its target.
bool Cleaner::may_move(int half_edge) const {
  const int v = graph_.origin[at(half_edge)], u = graph_.target(half_edge);
  if (rank(v) == 2 || rank(v) > rank(u))
    return false;
  if (rank(v) == 1 && !graph_.edge(half_edge).outline)
    return false;
  if (!has_only_cells_between(half_edge))
    return false;
  int out = half_edge;
  do {
    if (graph_.cell[at(out)] >= 0) {
      const std::vector<int> before = loop_of(out);
      std::vector<int> after = before;
      std::replace(after.begin(), after.end(), v, u);
      after.erase(std::unique(after.begin(), after.end()), after.end());
      if (after.size() > 1 && after.front() == after.back())
        after.pop_back();
      if (after.size() == 2) {  // the cell vanishes
        const int x = graph_.next[at(out)], y = graph_.previous[at(out)];
        const int other = graph_.cell[at(CutGraph::twin(x))];
        if (other == graph_.cell[at(CutGraph::twin(y))] || before.size() != 3)
          return false;
      } else if (!has_distinct_vertices(after) || (!valid(after) && valid(before))) {
        return false;
      }
    }
    out = graph_.next[at(CutGraph::twin(out))];
  } while (out != half_edge);
  return true;
}

// The cell x, y of two edges vanishes; x takes the place of the twin of y.
void Cleaner::remove_digon(int half_edge) {
  const int x = half_edge, y = graph_.next[at(x)];
  if (graph_.next[at(y)] != x)
    return;
  const int other = CutGraph::twin(y);
  graph_.next[at(x)] = graph_.next[at(other)];
  graph_.previous[at(x)] = graph_.previous[at(other)];
  graph_.next[at(graph_.previous[at(x)])] = x;
  graph_.previous[at(graph_.next[at(x)])] = x;
  graph_.cell[at(x)] = graph_.cell[at(other)];
  graph_.from(x).half_edge = x;
  graph_.from(y).half_edge = CutGraph::twin(x);
  CutGraph::Edge &kept = graph_.edge(x), &gone = graph_.edge(y);
  if (kept.line < 0 || gone.outline)
    kept.line = gone.line;
  kept.outline = kept.outline || gone.outline;
  kept.joint = kept.joint == 0 || gone.joint == 0 ? kept.joint + gone.joint
                                                  : std::min(kept.joint, gone.joint);
  gone.alive = false;
}

void Cleaner::contract(int half_edge) {
  const int v = graph_.origin[at(half_edge)], u = graph_.target(half_edge);
  CutGraph::Vertex &gone = graph_.vertices[at(v)], &kept = graph_.vertices[at(u)];
  report_.largest_move =
      std::max(report_.largest_move, (gone.place - kept.place).norm());
  ++report_.contractions;
  std::vector<int> around;
  for (int h = half_edge;;) {
    around.push_back(h);
    h = graph_.next[at(CutGraph::twin(h))];
    if (h == half_edge)
      break;
  }
  for (const int h : around) {
    graph_.origin[at(h)] = u;
    if (h != half_edge && !lies_on(kept, graph_.edge(h).line))
      graph_.edge(h).line = -1;
  }
  const int back = CutGraph::twin(half_edge);
  const int left = graph_.next[at(half_edge)], right = graph_.next[at(back)];
  for (const int h : {half_edge, back}) {
    graph_.next[at(graph_.previous[at(h)])] = graph_.next[at(h)];
    graph_.previous[at(graph_.next[at(h)])] = graph_.previous[at(h)];
  }
  kept.half_edge = left;
  gone.half_edge = -1;
  graph_.edge(half_edge).alive = false;
  remove_digon(left);
  if (graph_.alive(right))
    remove_digon(right);
}

bool Cleaner::try_contract(int e) {
  const int a = graph_.origin[2 * at(e)], b = graph_.origin[2 * at(e) + 1];
  const std::tuple<int, int, int> first{rank(a), graph_.degree(a), -a},
      second{rank(b), graph_.degree(b), -b};
  const int half_edge = first < second ? 2 * e : 2 * e + 1;  // the lower one moves
  for (const int h : {half_edge, CutGraph::twin(half_edge)})
    if (may_move(h)) {
      contract(h);
      return true;
    }
  return false;
}

void Cleaner::contract_below(double emin) {
  const double limit = emin * emin;
  const auto is_short = [limit](const Key& k) {
    return std::get<0>(k) < limit || std::get<0>(k) == 0.0;
  };
  std::set<Key> open, refused;
  for (std::size_t e = 0; e < graph_.edges.size(); ++e)
    if (const Key k = key(static_cast<int>(e)); graph_.edges[e].alive && is_short(k))
      open.insert(k);
  while (!open.empty()) {
    progress_.count(0, 1);
    const Key shortest = *open.begin();
    open.erase(open.begin());
    const int e = std::get<3>(shortest);
    if (!graph_.edges[at(e)].alive)
      continue;
    if (const Key now = key(e); now != shortest) {  // an end has moved
      if (is_short(now))
        open.insert(now);
      continue;
    }
    const int a = graph_.origin[2 * at(e)], b = graph_.origin[2 * at(e) + 1];
    if (!try_contract(e)) {
      refused.insert(shortest);
      continue;
    }
    // The cells around have changed. Edges that were refused there may be possible now.
    const int kept = graph_.vertices[at(a)].half_edge >= 0 ? a : b;
    const int begin = graph_.vertices[at(kept)].half_edge;
    int out = begin;
    do {
      for (int h = out;;) {
        const Key k = key(h / 2);
        if (is_short(k))
          open.insert(k);
        refused.erase(k);
        h = graph_.next[at(h)];
        if (h == out || graph_.cell[at(h)] < 0)
          break;
      }
      out = graph_.next[at(CutGraph::twin(out))];
    } while (out != begin);
  }
  report_.kept_short = static_cast<std::size_t>(
      std::count_if(refused.begin(), refused.end(), [this](const Key& k) {
        return graph_.edges[at(std::get<3>(k))].alive;
      }));
}

// Identifies the origins of two half-edges of one cell by an edge of length 0 between
// them, which is contracted. The edge splits the cell.
bool Cleaner::try_identify(int half_edge, int other) {
  const auto e = static_cast<int>(graph_.edges.size());
  const int forward = 2 * e, back = 2 * e + 1;
  graph_.edges.emplace_back();
  const int before = graph_.previous[at(half_edge)], cell = graph_.cell[at(half_edge)];
  const int before_other = graph_.previous[at(other)];
  for (const int from : {half_edge, other}) {
    graph_.origin.push_back(graph_.origin[at(from)]);
    graph_.cell.push_back(cell);
  }
  // forward leads from the first vertex to the other one, which its cell leaves by
  // `other`.
  graph_.next.insert(graph_.next.end(), {other, half_edge});
  graph_.previous.insert(graph_.previous.end(), {before, before_other});
  graph_.next[at(before)] = graph_.previous[at(other)] = forward;
  graph_.next[at(before_other)] = graph_.previous[at(half_edge)] = back;
  if (cells_ == 0)
    cells_ = *std::max_element(graph_.cell.begin(), graph_.cell.end()) + 1;
  const int new_cell = cells_++;
  graph_.cell[at(back)] = new_cell;
  for (int h = graph_.next[at(back)]; h != back; h = graph_.next[at(h)])
    graph_.cell[at(h)] = new_cell;
  if (try_contract(e))
    return true;
  for (int h = graph_.next[at(back)]; h != back; h = graph_.next[at(h)])
    graph_.cell[at(h)] = cell;
  graph_.remove_edge(at(e));
  return false;
}

// A cell that rounding has pinched has two vertices at one place. They become one, so
// that the cell becomes two, or loses a spike. Returns whether there were any.
bool Cleaner::identify_coinciding_vertices() {
  bool found = false;
  for (const int begin : destroyed_) {
    if (!graph_.alive(begin) || valid(loop_of(begin)))
      continue;
    std::vector<int> sides;
    for (int h = begin;;) {
      sides.push_back(h);
      h = graph_.next[at(h)];
      if (h == begin)
        break;
    }
    const auto place = [this](int h) { return graph_.from(h).place; };
    std::stable_sort(sides.begin(), sides.end(), [&](int g, int h) {
      const Vec2 p = place(g), q = place(h);
      return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
    });
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const int g = sides[i - 1], h = sides[i];
      if (place(g) == place(h) && graph_.origin[at(g)] != graph_.origin[at(h)] &&
          graph_.next[at(g)] != h && graph_.next[at(h)] != g && try_identify(g, h)) {
        found = true;
        break;
      }
    }
  }
  return found;
}

void Cleaner::join_if_straight(int vertex, std::map<int, int>& first) {
  if (graph_.vertices[at(vertex)].half_edge < 0 || graph_.degree(vertex) != 2 ||
      !is_superfluous(graph_, lines_, vertex))
    return;
  const int out = graph_.vertices[at(vertex)].half_edge;
  for (const int h : {out, graph_.next[at(CutGraph::twin(out))]})
    if (graph_.cell[at(h)] >= 0) {
      std::vector<int> loop = loop_of(h);
      loop.erase(std::find(loop.begin(), loop.end(), vertex));
      if (loop.size() < 3 || !valid(loop))
        return;
    }
  const int kept = graph_.join_edges(vertex);
  for (const int h : {2 * kept, 2 * kept + 1})
    if (graph_.cell[at(h)] >= 0)
      first[graph_.cell[at(h)]] = h;
}

// Merges the cell into the neighbour with the longest common chain. first: a half-edge
// of each cell.
bool Cleaner::try_merge(int cell, std::map<int, int>& first) {
  std::vector<int> sides;
  const int begin = first.at(cell);
  for (int h = begin;;) {
    sides.push_back(h);
    h = graph_.next[at(h)];
    if (h == begin)
      break;
  }
  const auto other = [this](int h) { return graph_.cell[at(CutGraph::twin(h))]; };
  // Begin where the neighbour changes, so that each chain is one run.
  std::size_t change = 0;
  while (change < sides.size() &&
         other(sides[change]) ==
             other(sides[(change + sides.size() - 1) % sides.size()]))
    ++change;
  if (change == sides.size())
    return false;  // a single neighbour encloses the cell, or the outside does
  std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(change),
              sides.end());
  struct Chain {
    double length = 0.0;
    int runs = 0;
    std::size_t begin = 0, end = 0;
  };
  std::map<int, Chain> chains;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    Chain& chain = chains[other(sides[i])];
    if (i == 0 || other(sides[i - 1]) != other(sides[i])) {
      ++chain.runs;
      chain.begin = i;
    }
    chain.end = i + 1;
    chain.length += graph_.length(at(sides[i]) / 2);
  }
  std::vector<std::pair<double, int>> order;
  for (const auto& [neighbour, chain] : chains)
    if (neighbour >= 0 && chain.runs == 1)
      order.emplace_back(-chain.length, neighbour);
  std::sort(order.begin(), order.end());
  for (const auto& [length, neighbour] : order) {
    const Chain& chain = chains.at(neighbour);
    const int into = sides[chain.begin], out = sides[chain.end - 1];
    std::vector<int> loop;  // around both cells
    for (int h = graph_.next[at(out)]; h != into; h = graph_.next[at(h)])
      loop.push_back(graph_.origin[at(h)]);
    const int last = CutGraph::twin(out), start = CutGraph::twin(into);
    for (int h = graph_.next[at(start)]; h != last; h = graph_.next[at(h)])
      loop.push_back(graph_.origin[at(h)]);
    // Two cells that rounding has destroyed may become one that is still not valid.
    const bool is_better =
        valid(loop) || (has_distinct_vertices(loop) && !valid(loop_of(begin)) &&
                        !valid(loop_of(first.at(neighbour))));
    if (loop.size() < 3 || !is_better)
      continue;
    const int ends[2] = {graph_.origin[at(into)], graph_.target(out)};
    first[neighbour] = graph_.next[at(out)];
    for (const int h : sides)
      graph_.cell[at(h)] = neighbour;
    for (std::size_t i = chain.begin; i < chain.end; ++i)
      graph_.remove_edge(at(sides[i]) / 2);
    first.erase(cell);
    ++report_.merges;
    for (const int end : ends)
      join_if_straight(end, first);
    return true;
  }
  return false;
}

void Cleaner::merge_below(double amin) {
  std::map<int, int> first;
  for (int h = 0; h < graph_.half_edges(); ++h)
    if (graph_.alive(h) && graph_.cell[at(h)] >= 0)
      first.emplace(graph_.cell[at(h)], h);
  const auto area = [&](int cell) {
    return section_properties(clockwise(loop_of(first.at(cell)))).area;
  };
  // Cells that rounding or contraction has destroyed are merged as well.
  const auto size_of = [&](int cell) {
    return valid(loop_of(first.at(cell))) ? area(cell) : -1.0;
  };
  const auto is_small = [amin](double size) { return size < amin || size < 0.0; };
  std::set<std::pair<double, int>> open;
  for (const auto& [cell, half_edge] : first)
    if (const double a = size_of(cell); is_small(a))
      open.emplace(a, cell);
  std::map<int, double> refused;
  while (!open.empty()) {
    progress_.count(1, 2);
    const auto [size, cell] = *open.begin();
    open.erase(open.begin());
    if (!first.contains(cell))
      continue;
    if (const double now = size_of(cell); now != size) {  // it has grown
      if (is_small(now))
        open.emplace(now, cell);
      continue;
    }
    if (try_merge(cell, first)) {
      for (const auto& [other, value] : refused)
        open.emplace(value, other);
      refused.clear();
    } else {
      refused.emplace(cell, size);
    }
  }
  report_.kept_small = refused.size();
  destroyed_.clear();
  for (const auto& [cell, size] : refused)
    if (size < 0.0)
      destroyed_.push_back(first.at(cell));
}

}  // namespace

bool is_superfluous(const CutGraph& graph, const std::vector<exact::Line>& lines,
                    int vertex) {
  const CutGraph::Vertex& v = graph.vertices[at(vertex)];
  if (v.corner >= 0)
    return false;
  const CutGraph::Edge& a = graph.edge(v.half_edge);
  const CutGraph::Edge& b = graph.edge(graph.next[at(CutGraph::twin(v.half_edge))]);
  return a.joint == b.joint && a.outline == b.outline && a.line >= 0 && b.line >= 0 &&
         (a.line == b.line || exact::parallel(lines[at(a.line)], lines[at(b.line)]));
}

void clean(CutGraph& graph, const std::vector<exact::Line>& lines, double emin,
           double amin, CutReport& report, StepProgress progress) {
  Cleaner cleaner(graph, lines, report, progress);
  // Edges whose contraction was not possible may be contracted after a merge. Each
  // round removes a vertex or a cell, so the loop ends.
  for (bool changed = true; changed;) {
    const std::size_t merges = report.merges;
    cleaner.contract_below(emin);
    cleaner.merge_below(amin);
    changed = cleaner.identify_coinciding_vertices() || report.merges > merges;
  }
}

}  // namespace blocks::geometry
