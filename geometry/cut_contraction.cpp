#include "geometry/cut_cleaner.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "geometry/exact/line.hpp"

namespace blocks::geometry {
namespace {

constexpr auto at = CutGraph::at;

}  // namespace

bool CutCleaner::lies_on(const CutGraph::Vertex& vertex, int line) const {
  if (line < 0)
    return false;
  if (line == vertex.first || line == vertex.second)
    return true;
  if (vertex.first < 0 || vertex.second < 0)
    return false;
  exact::Place place;
  place.set(lines_[at(vertex.first)], lines_[at(vertex.second)]);
  return exact::side_of(lines_[at(line)], place) == 0;
}

// Tests the link condition: the ends share no neighbours other than those of triangles
// at the edge. Otherwise contraction would make loops or fold a part of the mesh.
bool CutCleaner::has_only_cells_between(int half_edge) const {
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

// Tests whether the origin of the half-edge may move to vertex u, as far as its cell,
// which is not valid, is concerned.
bool CutCleaner::may_change_bad_cell(int half_edge, int u) const {
  std::vector<int> loop = loop_of(half_edge);
  std::replace(loop.begin(), loop.end(), graph_.origin[at(half_edge)], u);
  loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
  if (loop.size() > 1 && loop.front() == loop.back())
    loop.pop_back();
  return loop.size() > 2 && has_distinct_vertices(loop);
}

bool CutCleaner::is_held(int half_edge) const {
  return graph_.from(half_edge).is_protected &&
         graph_.length(at(half_edge) / 2) > repair_;
}

// Tests whether the origin of the half-edge may move to its target.
bool CutCleaner::may_move(int half_edge) {
  const int v = graph_.origin[at(half_edge)], u = graph_.target(half_edge);
  if (is_held(half_edge))
    return false;
  if (rank(v) == 2 || rank(v) > rank(u))
    return false;
  if (rank(v) == 1 && !graph_.edge(half_edge).outline)
    return false;
  if (!has_only_cells_between(half_edge))
    return false;
  int out = half_edge;
  do {
    if (graph_.cell[at(out)] >= 0) {
      const int x = graph_.next[at(out)], entry = graph_.previous[at(out)];
      const bool has_side = out == half_edge || graph_.origin[at(entry)] == u;
      if (has_side && graph_.next[at(x)] == entry) {  // a triangle vanishes
        // The two edges other than the contracted one coincide then.
        const int y = out == half_edge ? entry : out;
        if (graph_.cell[at(CutGraph::twin(x))] == graph_.cell[at(CutGraph::twin(y))])
          return false;
      } else if (validity_.is_valid(out)) {
        if (!validity_.remains_valid(out, u))
          return false;
      } else if (!may_change_bad_cell(out, u)) {
        return false;
      }
    }
    out = graph_.next[at(CutGraph::twin(out))];
  } while (out != half_edge);
  return true;
}

// The cell x, y of two edges vanishes; x takes the place of the twin of y.
void CutCleaner::remove_digon(int half_edge) {
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
  if (kept.is_protected != gone.is_protected)
    kept.joint = gone.joint = kept.is_protected ? kept.joint : gone.joint;
  kept.is_protected = kept.is_protected || gone.is_protected;
  kept.joint = kept.outline                         ? 0
               : kept.joint == 0 || gone.joint == 0 ? kept.joint + gone.joint
                                                    : std::min(kept.joint, gone.joint);
  gone.alive = false;
}

void CutCleaner::contract(int half_edge) {
  const int v = graph_.origin[at(half_edge)], u = graph_.target(half_edge);
  CutGraph::Vertex &gone = graph_.vertices[at(v)], &kept = graph_.vertices[at(u)];
  kept.is_protected = kept.is_protected || gone.is_protected;
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
    if (graph_.cell[at(h)] >= 0 && !validity_.is_valid(h))
      validity_.forget(graph_.cell[at(h)]);
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

bool CutCleaner::try_contract(int e) {
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

void CutCleaner::contract_below(double emin) {
  const double limit = emin * emin;
  const auto is_short = [limit](const Key& k) {
    return std::get<0>(k) < limit || std::get<0>(k) == 0.0;
  };
  std::set<Key> open;
  std::vector<bool> refused(graph_.edges.size(), false);
  std::size_t refusals = 0;
  const auto reopen = [&](int e) {
    if (refused[at(e)]) {
      refused[at(e)] = false;
      --refusals;
    }
    if (const Key k = key(e); is_short(k))
      open.insert(k);
  };
  for (std::size_t e = 0; e < graph_.edges.size(); ++e)
    if (graph_.edges[e].alive)
      reopen(static_cast<int>(e));
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
      refused[at(e)] = true;
      ++refusals;
      continue;
    }
    // The edges at the vertex have changed, and so have the cells around it. Edges that
    // were refused there may be possible now.
    const int kept = graph_.vertices[at(a)].half_edge >= 0 ? a : b;
    const int begin = graph_.vertices[at(kept)].half_edge;
    int out = begin;
    do {
      reopen(out / 2);
      if (refusals > 0 && graph_.cell[at(out)] >= 0)
        for (int h = graph_.next[at(out)]; h != out; h = graph_.next[at(h)])
          if (refused[at(h / 2)])
            reopen(h / 2);
      out = graph_.next[at(CutGraph::twin(out))];
    } while (out != begin);
  }
}

// Identifies the origins of two half-edges of one cell by an edge of length 0 between
// them, which is contracted. The edge splits the cell.
bool CutCleaner::try_identify(int half_edge, int other) {
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
  validity_.forget(cell);
  graph_.cell[at(back)] = new_cell;
  for (int h = graph_.next[at(back)]; h != back; h = graph_.next[at(h)])
    graph_.cell[at(h)] = new_cell;
  if (try_contract(e))
    return true;
  for (int h = graph_.next[at(back)]; h != back; h = graph_.next[at(h)])
    graph_.cell[at(h)] = cell;
  graph_.remove_edge(at(e));
  validity_.forget(cell);
  return false;
}

// A cell that rounding has pinched has two vertices at one place. They become one, so
// that the cell becomes two, or loses a spike. Returns whether there were any.
bool CutCleaner::identify_coinciding_vertices() {
  bool found = false;
  for (const int begin : destroyed_) {
    if (!graph_.alive(begin) || validity_.is_valid(begin))
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

}  // namespace blocks::geometry
