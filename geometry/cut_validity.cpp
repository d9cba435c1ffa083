#include "geometry/cut_validity.hpp"

#include <algorithm>

#include "geometry/exact/kernels.hpp"

namespace blocks::geometry {
namespace {

constexpr auto at = CutGraph::at;

// Tests whether the side b -> c lies on the side a -> b.
bool folds_back(const Vec2& a, const Vec2& b, const Vec2& c) {
  const auto p = exact::point(a), q = exact::point(b), r = exact::point(c);
  return CGAL::orientation(p, q, r) == CGAL::COLLINEAR &&
         !CGAL::collinear_are_ordered_along_line(p, q, r);
}

bool is_left_turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return CGAL::orientation(exact::point(a), exact::point(b), exact::point(c)) ==
         CGAL::LEFT_TURN;
}

bool is_before(const Vec2& a, const Vec2& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

// A side and its box.
struct BoxedSide {
  const Vec2 a, b;
  const Vec2 low = a.cwiseMin(b), high = a.cwiseMax(b);

  bool meets(const Vec2& c, const Vec2& d) const {
    if (std::min(c.x(), d.x()) > high.x() || std::max(c.x(), d.x()) < low.x() ||
        std::min(c.y(), d.y()) > high.y() || std::max(c.y(), d.y()) < low.y())
      return false;
    return CGAL::do_intersect(
        exact::Filtered::Segment_2(exact::point(a), exact::point(b)),
        exact::Filtered::Segment_2(exact::point(c), exact::point(d)));
  }
};

}  // namespace

bool CellValidity::is_valid(int half_edge) {
  State& known = state(graph_.cell[at(half_edge)]);
  if (known == State::unknown) {
    Polygon polygon;  // clockwise
    int h = half_edge;
    do {
      polygon.push_back(graph_.from(h).place);
      h = graph_.previous[at(h)];
    } while (h != half_edge);
    const OutlineCheck check = check_outline(polygon);
    known = check.fault == OutlineFault::none && !check.anticlockwise ? State::valid
                                                                      : State::invalid;
  }
  return known == State::valid;
}

bool CellValidity::remains_valid(int half_edge, int u) const {
  const int entry = graph_.previous[at(half_edge)];
  const int p = graph_.origin[at(entry)], q = graph_.target(half_edge);
  const Vec2 &before = place(p), &moved = place(u), &after = place(q);
  const bool has_entry = u != p, has_exit = u != q;  // sides p -> u and u -> q
  if ((has_entry && before == moved) || (has_exit && moved == after) ||
      (has_entry && has_exit && folds_back(before, moved, after)))
    return false;
  const BoxedSide in{before, moved}, out{moved, after};
  const int first = graph_.next[at(half_edge)], last = graph_.previous[at(entry)];
  // The turn at the lexicographically smallest corner tells the orientation.
  const Vec2* corner = &before;
  const Vec2* corner_before = &place(graph_.origin[at(last)]);
  const Vec2* corner_after = has_entry ? &moved : &after;
  if (has_entry && has_exit && is_before(moved, *corner)) {
    corner = &moved;
    corner_before = &before;
    corner_after = &after;
  }
  for (int h = first;; h = graph_.next[at(h)]) {
    const int from = graph_.origin[at(h)], to = graph_.target(h);
    if (from == u && has_exit)
      return false;
    const Vec2 &s = place(from), &t = place(to);
    if (is_before(s, *corner)) {
      corner = &s;
      corner_before = h != first ? &place(graph_.origin[at(graph_.previous[at(h)])])
                      : has_exit ? &moved
                                 : &before;
      corner_after = &t;
    }
    if (has_entry) {
      const bool at_end = h == first && !has_exit;
      if (h == last && folds_back(s, before, moved))
        return false;
      if (at_end && folds_back(before, moved, t))
        return false;
      if (h != last && !at_end && in.meets(s, t))
        return false;
    }
    if (has_exit) {
      const bool at_begin = h == last && !has_entry;
      if (h == first && folds_back(moved, after, t))
        return false;
      if (at_begin && folds_back(s, moved, after))
        return false;
      if (h != first && !at_begin && out.meets(s, t))
        return false;
    }
    if (h == last)
      break;
  }
  return is_left_turn(*corner_before, *corner, *corner_after);
}

bool CellValidity::merge_is_valid(int into, int out) const {
  const int last = graph_.previous[at(into)], end = CutGraph::twin(out);
  const int first_other = graph_.next[at(CutGraph::twin(into))],
            last_other = graph_.previous[at(end)];
  const int first = graph_.next[at(out)];
  for (int g = first; g != into; g = graph_.next[at(g)]) {
    const BoxedSide side{place(graph_.origin[at(g)]), place(graph_.target(g))};
    for (int h = first_other; h != end; h = graph_.next[at(h)]) {
      const Vec2 &s = place(graph_.origin[at(h)]), &t = place(graph_.target(h));
      const bool follows = g == last && h == first_other;
      const bool precedes = g == first && h == last_other;
      if (follows    ? folds_back(side.a, side.b, t)
          : precedes ? folds_back(s, side.a, side.b)
                     : side.meets(s, t))
        return false;
    }
  }
  // Both cells are clockwise, so is the sum of their windings.
  return true;
}

}  // namespace blocks::geometry
