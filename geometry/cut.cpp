#include "geometry/cut.hpp"

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometry/cut_blocks.hpp"
#include "geometry/cut_cleaning.hpp"
#include "geometry/cut_graph.hpp"
#include "geometry/exact/joint_arrangement.hpp"
#include "geometry/exact/shared_point.hpp"
#include "geometry/numeric_environment.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

constexpr auto at = CutGraph::at;
using exact::Integer;
using exact::Line;
using exact::Place;
using exact::Point;
using exact::Rational;

std::vector<Point> exact_outline(const CutRequest& request) {
  std::vector<Point> outline;
  for (const DecimalPoint& corner : request.outline)
    outline.push_back(exact::rational(corner));
  return outline;
}

std::vector<Vec2> rounded_outline(const CutRequest& request,
                                  const std::vector<Point>& outline) {
  if (request.rounded)
    return *request.rounded;
  std::vector<Vec2> corners;
  for (const Point& corner : outline)
    corners.push_back(exact::nearest(corner));
  return corners;
}

Rational twice_area(const std::vector<Point>& p) {  // positive if anticlockwise
  Rational sum = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i)
    sum += exact::cross(p[i] - p[0], p[i + 1] - p[0]);
  return sum;
}

void check_request(const CutRequest& request, const std::vector<Point>& outline,
                   const std::vector<Vec2>& corners) {
  const auto refuse = [&](CutError::Kind kind, const std::string& message,
                          const Vec2& place, const std::string& hint) {
    throw CutError(kind, message, place, hint);
  };
  const OutlineCheck check = check_outline(corners);
  const Vec2 place = corners.empty()   ? Vec2(0.0, 0.0)
                     : check.first < 0 ? corners[0]
                                       : corners[at(check.first) % corners.size()];
  if (corners.size() != outline.size() || check.fault != OutlineFault::none)
    refuse(CutError::Kind::outline, "the outline is not simple: " + describe(check),
           place, "give at least three corners, clockwise");
  if (check.anticlockwise)
    refuse(CutError::Kind::outline, "the outline is anticlockwise", place,
           "give the corners clockwise");
  if (!CGAL::is_simple_2(outline.begin(), outline.end(), exact::Kernel()) ||
      twice_area(outline) >= 0)
    refuse(CutError::Kind::outline, "the outline is not simple before rounding", place,
           "move corners apart");
  for (const JointSegment& joint : request.joints)
    for (const Vec2& end : {joint.from.nearest(), joint.to.nearest()})
      if (!end.allFinite())
        refuse(CutError::Kind::joint, "a joint has an end that is not finite", place,
               "give finite coordinates");
  for (const JointSegment& joint : request.joints)
    if (joint.id < 0)
      refuse(CutError::Kind::joint, "a joint id is negative", joint.from.nearest(),
             "give 0 or more");
  Vec2 low = corners[0], high = corners[0];
  for (const Vec2& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double area = section_properties(corners).area;
  if (!(request.emin >= 0.0) || request.emin >= (high - low).maxCoeff())
    refuse(CutError::Kind::cleaning, "emin is not between 0 and the size of the domain",
           place, "give a part of the smallest edge that matters");
  if (!(request.amin >= 0.0) || request.amin >= area)
    refuse(CutError::Kind::cleaning, "amin is not between 0 and the area of the domain",
           place, "give a part of the smallest cell that matters");
}

// Rounds points on a side of the outline. On a slanted side each coordinate is rounded
// towards the domain, so that neither the exact line nor the line of the rounded
// corners is crossed. Layers on the other side of the line do the same (see RoundedLine
// in layer.cpp).
Vec2 round_on_side(const Point& p, const Point& from, const Point& to,
                   const Vec2& start, const Vec2& end) {
  const int rises = CGAL::sign(to.y() - from.y()), runs = CGAL::sign(to.x() - from.x());
  if (rises == 0 || runs == 0) {
    Vec2 place = exact::nearest(p);
    // The coordinate of the side may have been chosen together with other outlines.
    if (rises == 0 && start.y() == end.y())
      place.y() = start.y();
    if (runs == 0 && start.x() == end.x())
      place.x() = start.x();
    return place;
  }
  // The domain is on the right of its clockwise sides.
  const int x_side = rises, y_side = -runs;
  const Rational s = (p.x() - from.x()) / (to.x() - from.x());
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
  Rounder(const CutGraph& graph, const std::vector<Line>& lines,
          const std::vector<Point>& outline, const std::vector<Vec2>& corners)
      : graph_(graph), lines_(lines), outline_(outline), corners_(corners) {}

  CutGraph rounded(StepProgress progress) {
    std::vector<int> order;
    places_.resize(graph_.vertices.size());
    for (std::size_t v = 0; v < graph_.vertices.size(); ++v)
      if (graph_.vertices[v].half_edge >= 0) {
        progress.count(v, graph_.vertices.size());
        places_[v] = round(graph_.vertices[v]);
        order.push_back(static_cast<int>(v));
      }
    std::sort(order.begin(), order.end(), [this](int a, int b) { return less(a, b); });
    return renumbered(order);
  }

 private:
  Place exact_place(const CutGraph::Vertex& v) const {
    return exact::intersection(lines_[at(v.first)], lines_[at(v.second)]);
  }
  Vec2 round(const CutGraph::Vertex& v) const {
    if (v.corner >= 0)
      return corners_[at(v.corner)];
    if (v.second < 0)
      return v.place;
    if (v.side < 0)
      return exact_place(v).nearest();
    const std::size_t i = at(v.side), j = (i + 1) % outline_.size();
    return round_on_side(exact_place(v).reduced(), outline_[i], outline_[j],
                         corners_[i], corners_[j]);
  }
  bool less(int a, int b) const {
    const Vec2 &p = places_[at(a)], &q = places_[at(b)];
    if (p != q)
      return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
    const auto &v = graph_.vertices[at(a)], &w = graph_.vertices[at(b)];
    if (a == b || v.second < 0 || w.second < 0)
      return v.second < w.second;  // both are doubles only if they are the same
    return exact_place(v).reduced() < exact_place(w).reduced();
  }
  CutGraph renumbered(const std::vector<int>& order) const {
    CutGraph result;
    std::vector<int> number(graph_.vertices.size(), -1);
    for (const int v : order) {
      number[at(v)] = static_cast<int>(result.vertices.size());
      result.vertices.push_back(graph_.vertices[at(v)]);
      result.vertices.back().place = places_[at(v)] + Vec2(0.0, 0.0);  // no -0
    }
    std::vector<std::tuple<int, int, int>> edges;  // lower end, higher end, half-edge
    for (int h = 0; h < graph_.half_edges(); ++h) {
      const int from = number[at(graph_.origin[at(h)])];
      const int to = number[at(graph_.target(h))];
      if (graph_.alive(h) && from < to)
        edges.emplace_back(from, to, h);
    }
    std::sort(edges.begin(), edges.end());
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
  const std::vector<Line>& lines_;
  const std::vector<Point>& outline_;
  const std::vector<Vec2>& corners_;
  std::vector<Vec2> places_;
};

std::size_t join_straight_edges(CutGraph& graph, const std::vector<Line>& lines) {
  std::size_t joined = 0;
  for (int v = 0; v < static_cast<int>(graph.vertices.size()); ++v)
    if (graph.vertices[at(v)].half_edge >= 0 && graph.degree(v) == 2 &&
        is_superfluous(graph, lines, v)) {
      graph.join_edges(v);
      ++joined;
    }
  return joined;
}

// Copies vertices, cells and outline into the result, and counts T and X vertices.
StraightCorners fill_mesh(const CutGraph& graph, const std::vector<Line>& lines,
                          CutResult& result) {
  Mesh& mesh = result.mesh;
  std::vector<int> number(graph.vertices.size(), -1);
  for (std::size_t v = 0; v < graph.vertices.size(); ++v)
    if (graph.vertices[v].half_edge >= 0) {
      number[v] = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(graph.vertices[v].place);
    }
  const auto numbered = [&](int h) { return number[at(graph.origin[at(h)])]; };
  // A clockwise turn around a cell follows `previous`. The first half-edge of a cell is
  // the one that begins at its lowest vertex.
  std::vector<int> first(at(graph.half_edges()), -1);
  for (int h = 0; h < graph.half_edges(); ++h) {
    if (!graph.alive(h) || graph.cell[at(h)] < 0)
      continue;
    int& lowest = first[at(graph.cell[at(h)])];
    if (lowest < 0 || numbered(h) < numbered(lowest))
      lowest = h;
  }
  first.erase(std::remove(first.begin(), first.end(), -1), first.end());
  std::sort(first.begin(), first.end(), [&](int g, int h) {
    return std::pair(numbered(g), numbered(graph.previous[at(g)])) <
           std::pair(numbered(h), numbered(graph.previous[at(h)]));
  });
  StraightCorners straight;
  std::vector<bool> is_t(mesh.vertices.size(), false);
  for (const int begin : first) {
    std::vector<int> cell, joints;
    std::vector<bool> corners;
    int h = begin;
    do {
      // Clockwise, the edge before the origin of h is h itself.
      const int out = graph.previous[at(h)];
      const CutGraph::Edge &a = graph.edge(h), &b = graph.edge(out);
      const CutGraph::Vertex& vertex = graph.from(h);
      const bool on_line =
          vertex.corner < 0 && a.line >= 0 && b.line >= 0 && a.joint == b.joint &&
          (a.line == b.line || exact::parallel(lines[at(a.line)], lines[at(b.line)])) &&
          graph.degree(graph.origin[at(h)]) > 2;
      cell.push_back(numbered(h));
      joints.push_back(b.joint);
      corners.push_back(on_line);
      if (on_line)
        is_t[at(numbered(h))] = true;
      h = out;
    } while (h != begin);
    mesh.cells.push_back(std::move(cell));
    result.joints.push_back(std::move(joints));
    straight.push_back(std::move(corners));
  }
  int start = -1;
  for (int h = 0; h < graph.half_edges(); ++h)
    if (graph.alive(h) && graph.cell[at(h)] < 0 && graph.from(h).corner == 0)
      start = h;
  for (int h = start; h >= 0;) {
    mesh.outline.push_back(numbered(h));
    h = graph.next[at(h)];
    if (h == start)
      break;
  }
  for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
    if (number[v] < 0)
      continue;
    if (is_t[at(number[v])])
      ++result.report.t_vertices;
    else if (graph.vertices[v].side < 0 && graph.degree(static_cast<int>(v)) >= 4)
      ++result.report.x_vertices;
  }
  return straight;
}

[[noreturn]] void refuse(const CutRequest& request, const CutResult& result,
                         const std::string& fault) {
  Vec2 place = result.mesh.vertices.empty() ? Vec2(0.0, 0.0) : result.mesh.vertices[0];
  if (!result.certificate.offending_cells.empty()) {
    const auto& cell = result.mesh.cells[at(result.certificate.offending_cells[0])];
    place = result.mesh.vertices[at(cell[0])];
  }
  throw CutError(CutError::Kind::certificate,
                 "cells are thinner than doubles can represent: " + fault, place,
                 request.emin > 0.0 && request.amin > 0.0
                     ? "give larger emin and amin, or remove one of two joints that "
                       "nearly coincide there"
                     : "give emin and amin, such as 1e-6 of the size of a block");
}

// The areas of the cells add up to that of their common outline, exactly.
bool areas_add_up(const Mesh& mesh) {
  using CGAL::Mpzf;
  const auto twice = [&mesh](const std::vector<int>& loop) {
    Mpzf sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2& p = mesh.vertices[at(loop[i])];
      const Vec2& q = mesh.vertices[at(loop[(i + 1) % loop.size()])];
      sum = sum + Mpzf(p.x()) * Mpzf(q.y()) - Mpzf(q.x()) * Mpzf(p.y());
    }
    return sum;
  };
  Mpzf rest = twice(mesh.outline);
  for (const std::vector<int>& cell : mesh.cells)
    rest = rest - twice(cell);
  return CGAL::sign(rest) == CGAL::ZERO;
}

// Adds the length of each joint id to the report, and returns the sum.
double add_lengths(const CutGraph& graph, CutReport& report) {
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    if (graph.edges[e].alive && !graph.edges[e].outline)
      report.lengths[graph.edges[e].joint].drawn += graph.length(e);
  double sum = 0.0;
  for (const auto& [joint, length] : report.lengths)
    sum += length.drawn;
  return sum;
}

double inner_length(const CutGraph& graph) {
  double length = 0.0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    if (graph.edges[e].alive && !graph.edges[e].outline)
      length += graph.length(e);
  return length;
}

}  // namespace

ExactPoint::ExactPoint(const Vec2& p) : nearest_(p) {}

ExactPoint::ExactPoint(const DecimalPoint& p)
    : ExactPoint(exact::exact_point(exact::rational(p))) {}

ExactPoint::ExactPoint(std::shared_ptr<const exact::SharedPoint> point)
    : nearest_(exact::nearest(point->point)), exact_(std::move(point)) {}

CutResult cut_outline(const CutRequest& request) {
  const RoundToNearest mode;
  const std::vector<Point> outline = exact_outline(request);
  const std::vector<Vec2> corners = rounded_outline(request, outline);
  check_request(request, outline, corners);
  const double area = section_properties(corners).area;

  CutResult result;
  CutReport& report = result.report;
  exact::JointArrangement arrangement =
      exact::arrange_joints(outline, request.joints, request.progress);
  StepProgress(request.progress, "prune joints", 0.6);
  report.p21_before = add_lengths(arrangement.graph, report) / area;
  keep_separating_edges(arrangement.graph, report);
  report.p21_after = inner_length(arrangement.graph) / area;
  report.straight_vertices = join_straight_edges(arrangement.graph, arrangement.lines);
  CutGraph graph =
      Rounder(arrangement.graph, arrangement.lines, outline, corners)
          .rounded(StepProgress(request.progress, "round vertices", 0.7, 0.8));
  arrangement.graph = {};
  graph.number_cells();
  clean(graph, arrangement.lines, request.emin, request.amin, report,
        StepProgress(request.progress, "clean cells", 0.8, 0.85));
  const StraightCorners straight = fill_mesh(graph, arrangement.lines, result);
  make_blocks(result, straight,
              StepProgress(request.progress, "certify cells", 0.85, 1.0));
  if (!result.certificate.holds)
    refuse(request, result, result.certificate.fault);
  if (!areas_add_up(result.mesh))
    refuse(request, result, "the areas of the cells do not add up");
  return result;
}

}  // namespace blocks::geometry
