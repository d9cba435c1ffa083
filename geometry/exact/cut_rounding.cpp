#include "geometry/exact/cut_rounding.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace blocks::geometry {
namespace {

constexpr auto at = CutGraph::at;
using exact::Lines;
using exact::Point;
using exact::Rational;

// Rounds points on a side of the outline. On a slanted side each coordinate is rounded
// towards the domain, so that neither the exact line nor the line of the rounded
// corners is crossed. Layers on the other side of the line do the same (see RoundedLine
// in exact/rounded_line.hpp).
Vec2 round_on_side(const Point& p, const Point& from, const Point& to,
                   const Vec2& start, const Vec2& end) {
  // The corners may have been chosen together with other outlines, so that an
  // axis-parallel side has another coordinate, or becomes slanted.
  if (from.y() == to.y() && start.y() == end.y())
    return {exact::nearest(p.x()), start.y()};
  if (from.x() == to.x() && start.x() == end.x())
    return {start.x(), exact::nearest(p.y())};
  const auto direction = [](double rounded, const Rational& exactly) {
    return rounded != 0.0 ? (rounded > 0.0 ? 1 : -1)
                          : static_cast<int>(CGAL::sign(exactly));
  };
  const int rises = direction(end.y() - start.y(), to.y() - from.y());
  const int runs = direction(end.x() - start.x(), to.x() - from.x());
  // The domain is on the right of its clockwise sides.
  const int x_side = rises, y_side = -runs;
  const Rational s = from.x() != to.x() ? (p.x() - from.x()) / (to.x() - from.x())
                                        : (p.y() - from.y()) / (to.y() - from.y());
  const Rational ax(start.x()), ay(start.y()), bx(end.x()), by(end.y());
  const auto inner = [](const Rational& a, const Rational& b, int side) {
    return exact::rounded_towards(side < 0 ? std::min(a, b) : std::max(a, b), side);
  };
  return {inner(p.x(), ax + (bx - ax) * s, x_side),
          inner(p.y(), ay + (by - ay) * s, y_side)};
}

// Rounds the vertices and returns a graph whose vertices are in order of their places.
// So numbers of vertices and edges do not depend on the order of the joints.
class Rounder {
 public:
  Rounder(const exact::JointArrangement& arrangement, const std::vector<Point>& outline,
          const std::vector<Vec2>& corners)
      : graph_(arrangement.graph), lines_(arrangement.lines),
        points_(arrangement.points), outline_(outline), corners_(corners) {}

  CutGraph rounded(StepProgress progress) {
    std::vector<int> order;
    places_.resize(graph_.vertices.size());
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v)
      if (graph_.vertices[v].half_edge >= 0) {
        progress.count(v, graph_.vertices.size());
        places_[v] = round(graph_.vertices[v]);
        order.push_back(static_cast<int>(v));
      }
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      progress.count(1, 1);
      return less(a, b);
    });
    return renumbered(order, progress);
  }

 private:
  Point exact_place(const CutGraph::Vertex& v) const {
    if (v.point >= 0)
      return exact::point_of(points_[at(v.point)]);
    exact::Place place;
    place.set(lines_[at(v.first)], lines_[at(v.second)]);
    return place.reduced();
  }
  Vec2 round(const CutGraph::Vertex& v) const {
    if (v.corner >= 0)
      return corners_[at(v.corner)];
    if (v.side < 0)
      return v.place;
    const std::size_t i = at(v.side), j = (i + 1) % outline_.size();
    return round_on_side(exact_place(v), outline_[i], outline_[j], corners_[i],
                         corners_[j]);
  }
  bool less(int a, int b) const {
    const Vec2 &p = places_[at(a)], &q = places_[at(b)];
    if (p != q)
      return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
    return a != b &&
           exact_place(graph_.vertices[at(a)]) < exact_place(graph_.vertices[at(b)]);
  }
  CutGraph renumbered(const std::vector<int>& order, StepProgress& progress) const {
    CutGraph result;
    std::vector<int> number(graph_.vertices.size(), -1);
    for (const int v : order) {
      number[at(v)] = static_cast<int>(result.vertices.size());
      result.vertices.push_back(graph_.vertices[at(v)]);
      result.vertices.back().place = places_[at(v)] + Vec2(0.0, 0.0);  // no -0
    }
    std::vector<std::tuple<int, int, int>> edges;  // lower end, higher end, half-edge
    for (int h = 0; h < graph_.half_edges(); ++h) {
      progress.count(1, 1);
      const int from = number[at(graph_.origin[at(h)])];
      const int to = number[at(graph_.target(h))];
      if (graph_.alive(h) && from < to)
        edges.emplace_back(from, to, h);
    }
    std::sort(edges.begin(), edges.end(), [&progress](const auto& a, const auto& b) {
      progress.count(1, 1);
      return a < b;
    });
    std::vector<int> half_edge(at(graph_.half_edges()), -1);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const int h = std::get<2>(edges[e]);
      half_edge[at(h)] = static_cast<int>(2 * e);
      half_edge[at(CutGraph::twin(h))] = static_cast<int>(2 * e + 1);
      result.edges.push_back(graph_.edge(h));
    }
    const std::size_t count = 2 * edges.size();
    result.origin.resize(count);
    result.next.resize(count);
    result.previous.resize(count);
    result.cell.resize(count);
    for (int h = 0; h < graph_.half_edges(); ++h) {
      progress.count(1, 1);
      if (!graph_.alive(h))
        continue;
      const std::size_t i = at(half_edge[at(h)]);
      result.origin[i] = number[at(graph_.origin[at(h)])];
      result.next[i] = half_edge[at(graph_.next[at(h)])];
      result.previous[i] = half_edge[at(graph_.previous[at(h)])];
      result.cell[i] = graph_.cell[at(h)];
    }
    for (std::size_t i = count; i-- > 0;)
      result.vertices[at(result.origin[i])].half_edge = static_cast<int>(i);
    return result;
  }

  const CutGraph& graph_;
  const Lines& lines_;
  const std::vector<ExactPoint>& points_;
  const std::vector<Point>& outline_;
  const std::vector<Vec2>& corners_;
  std::vector<Vec2> places_;
};

}  // namespace

CutGraph round_vertices(const exact::JointArrangement& arrangement,
                        const std::vector<Point>& outline,
                        const std::vector<Vec2>& corners, StepProgress progress) {
  return Rounder(arrangement, outline, corners).rounded(std::move(progress));
}

}  // namespace blocks::geometry
