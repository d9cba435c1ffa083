#include "geometry/cut_cleaner.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace blocks::geometry {
namespace {

constexpr auto at = CutGraph::at;

}  // namespace

void CutCleaner::join_if_straight(int vertex) {
  if (graph_.vertices[at(vertex)].half_edge < 0 || graph_.degree(vertex) != 2 ||
      !is_superfluous(graph_, lines_, vertex))
    return;
  const int out = graph_.vertices[at(vertex)].half_edge;
  for (const int h : {out, graph_.next[at(CutGraph::twin(out))]})
    if (graph_.cell[at(h)] >= 0) {
      if (graph_.next[at(graph_.next[at(graph_.next[at(h)])])] == h)
        return;
      if (validity_.is_valid(h)) {
        if (!validity_.remains_valid(h, graph_.target(h)))
          return;
        continue;
      }
      std::vector<int> loop = loop_of(h);
      loop.erase(std::find(loop.begin(), loop.end(), vertex));
      if (loop.size() < 3 || !valid(loop))
        return;
    }
  const int kept = graph_.join_edges(vertex);
  for (const int h : {2 * kept, 2 * kept + 1})
    if (graph_.cell[at(h)] >= 0) {
      first_[at(graph_.cell[at(h)])] = h;
      validity_.set_valid(graph_.cell[at(h)]);
      changed_.push_back(graph_.cell[at(h)]);
    }
}

// Contraction may leave two collinear edges of one joint, or of the outline.
void CutCleaner::join_straight_edges() {
  find_first_half_edges();
  for (int v = 0; v < static_cast<int>(graph_.vertices.size()); ++v) {
    progress_.count(1, 1);
    join_if_straight(v);
  }
}

void CutCleaner::find_first_half_edges() {
  first_.clear();
  for (int h = 0; h < graph_.half_edges(); ++h) {
    progress_.count(0, 1);
    const int cell = graph_.cell[at(h)];
    if (!graph_.alive(h) || cell < 0)
      continue;
    if (at(cell) >= first_.size())
      first_.resize(at(cell) + 1, -1);
    if (first_[at(cell)] < 0)
      first_[at(cell)] = h;
  }
}

// Merges the cell into the neighbour with the longest common chain.
bool CutCleaner::try_merge(int cell) {
  std::vector<int> sides;
  const int begin = first_[at(cell)];
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
    bool is_protected = false;
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
    chain.is_protected = chain.is_protected || graph_.edge(sides[i]).is_protected;
  }
  std::vector<std::pair<double, int>> order;
  const bool is_broken = !validity_.is_valid(begin);
  for (const auto& [neighbour, chain] : chains)
    if (neighbour >= 0 && chain.runs == 1 && (is_broken || !chain.is_protected))
      order.emplace_back(-chain.length, neighbour);
  std::sort(order.begin(), order.end());
  for (const auto& [length, neighbour] : order) {
    const Chain& chain = chains.at(neighbour);
    const int into = sides[chain.begin], out = sides[chain.end - 1];
    const bool are_valid =
        validity_.is_valid(begin) && validity_.is_valid(first_[at(neighbour)]);
    bool is_valid_now = false;
    if (are_valid && graph_.origin[at(into)] != graph_.target(out)) {
      const bool has_area =
          graph_.next[at(graph_.next[at(out)])] != into ||
          graph_.next[at(graph_.next[at(CutGraph::twin(into))])] != CutGraph::twin(out);
      is_valid_now = has_area && validity_.merge_is_valid(into, out);
      if (!is_valid_now)
        continue;
    } else {
      std::vector<int> loop;  // around both cells
      for (int h = graph_.next[at(out)]; h != into; h = graph_.next[at(h)])
        loop.push_back(graph_.origin[at(h)]);
      const int last = CutGraph::twin(out), start = CutGraph::twin(into);
      for (int h = graph_.next[at(start)]; h != last; h = graph_.next[at(h)])
        loop.push_back(graph_.origin[at(h)]);
      is_valid_now = valid(loop);
      // Two cells that rounding has destroyed may become one that is still not valid.
      const bool is_better =
          is_valid_now || (has_distinct_vertices(loop) && !validity_.is_valid(begin) &&
                           !validity_.is_valid(first_[at(neighbour)]));
      if (loop.size() < 3 || !is_better)
        continue;
    }
    const int ends[2] = {graph_.origin[at(into)], graph_.target(out)};
    first_[at(neighbour)] = graph_.next[at(out)];
    for (const int h : sides)
      graph_.cell[at(h)] = neighbour;
    for (std::size_t i = chain.begin; i < chain.end; ++i)
      graph_.remove_edge(at(sides[i]) / 2);
    first_[at(cell)] = -1;
    if (is_valid_now)
      validity_.set_valid(neighbour);
    else
      validity_.forget(neighbour);
    ++report_.merges;
    changed_ = {neighbour};
    for (const int end : ends)
      join_if_straight(end);
    return true;
  }
  return false;
}

void CutCleaner::merge_below(double amin) {
  find_first_half_edges();
  const auto area = [&](int cell) {
    return section_properties(clockwise(loop_of(first_[at(cell)]))).area;
  };
  // Cells that rounding or contraction has destroyed are merged as well.
  const auto size_of = [&](int cell) {
    return validity_.is_valid(first_[at(cell)]) ? area(cell) : -1.0;
  };
  const auto is_small = [amin](double size) { return size < amin || size < 0.0; };
  std::set<std::pair<double, int>> open;
  for (int cell = 0; cell < static_cast<int>(first_.size()); ++cell) {
    progress_.count(1, 2);
    if (first_[at(cell)] < 0)
      continue;
    if (const double a = size_of(cell); is_small(a))
      open.emplace(a, cell);
  }
  std::map<int, double> refused;
  // A refused cell may be possible if it has changed, or a neighbour has.
  const auto reopen = [&] {
    for (const int changed : changed_) {
      if (refused.empty())
        return;
      const int begin = first_[at(changed)];
      int h = begin;
      do {
        for (const int side : {h, CutGraph::twin(h)})
          if (const auto found = refused.find(graph_.cell[at(side)]);
              found != refused.end()) {
            open.emplace(found->second, found->first);
            refused.erase(found);
          }
        h = graph_.next[at(h)];
      } while (h != begin);
    }
  };
  while (!open.empty()) {
    progress_.count(1, 2);
    const auto [size, cell] = *open.begin();
    open.erase(open.begin());
    if (first_[at(cell)] < 0)
      continue;
    if (const double now = size_of(cell); now != size) {  // it has grown
      if (is_small(now))
        open.emplace(now, cell);
      continue;
    }
    if (try_merge(cell)) {
      reopen();
    } else {
      refused.emplace(cell, size);
    }
  }
  report_.kept_small = refused.size();
  destroyed_.clear();
  for (const auto& [cell, size] : refused)
    if (size < 0.0)
      destroyed_.push_back(first_[at(cell)]);
}

}  // namespace blocks::geometry
