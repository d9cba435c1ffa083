#include "geometry/cut.hpp"

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/cut_blocks.hpp"
#include "geometry/cut_certificate.hpp"
#include "geometry/cut_cleaning.hpp"
#include "geometry/cut_graph.hpp"
#include "geometry/exact/cut_rounding.hpp"
#include "geometry/exact/joint_arrangement.hpp"
#include "geometry/numeric_environment.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

constexpr auto at = CutGraph::at;
using exact::Lines;
using exact::Point;
using exact::Rational;

std::vector<Point> exact_outline(const CutRequest& request) {
  std::vector<Point> outline;
  for (const DecimalPoint& corner : request.outline)
    outline.push_back(exact::rational(corner));
  return outline;
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
  for (const Vec2& corner : corners)
    if (!(corner.cwiseAbs().maxCoeff() <= largest_coordinate))
      refuse(CutError::Kind::outline, "a corner is too far away to calculate with",
             corner, "choose another unit of length");
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
  if (!(area > 0.0))
    refuse(CutError::Kind::outline, "the area is too small to calculate with", place,
           "choose another unit of length");
  if (!(request.emin >= 0.0) || request.emin >= (high - low).maxCoeff())
    refuse(CutError::Kind::cleaning, "emin is not between 0 and the size of the domain",
           place, "give a part of the smallest edge that matters");
  if (!(request.amin >= 0.0) || request.amin >= area)
    refuse(CutError::Kind::cleaning, "amin is not between 0 and the area of the domain",
           place, "give a part of the smallest cell that matters");
}

std::size_t join_straight_edges(CutGraph& graph, const Lines& lines,
                                StepProgress& progress) {
  std::size_t joined = 0;
  for (int v = 0; v < static_cast<int>(graph.vertices.size()); ++v) {
    progress.count(1, 1);
    if (graph.vertices[at(v)].half_edge >= 0 && graph.degree(v) == 2 &&
        is_superfluous(graph, lines, v)) {
      graph.join_edges(v);
      ++joined;
    }
  }
  return joined;
}

// Copies vertices, cells and outline into the result, and counts T and X vertices.
StraightCorners fill_mesh(const CutGraph& graph, const Lines& lines, CutResult& result,
                          StepProgress& progress) {
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
    progress.count(1, 1);
    if (!graph.alive(h) || graph.cell[at(h)] < 0)
      continue;
    int& lowest = first[at(graph.cell[at(h)])];
    if (lowest < 0 || numbered(h) < numbered(lowest))
      lowest = h;
  }
  first.erase(std::remove(first.begin(), first.end(), -1), first.end());
  std::sort(first.begin(), first.end(), [&](int g, int h) {
    progress.count(1, 1);
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
      progress.count(1, 1);
      // Clockwise, the edge before the origin of h is h itself.
      const int out = graph.previous[at(h)];
      const CutGraph::Edge &a = graph.edge(h), &b = graph.edge(out);
      const CutGraph::Vertex& vertex = graph.from(h);
      const bool on_line =
          vertex.corner < 0 && a.line >= 0 && b.line >= 0 && a.joint == b.joint &&
          (a.line == b.line || lines.are_parallel(at(a.line), at(b.line))) &&
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
    progress.count(1, 1);
    if (number[v] < 0)
      continue;
    if (is_t[at(number[v])])
      ++result.report.t_vertices;
    else if (graph.vertices[v].side < 0 && graph.degree(static_cast<int>(v)) >= 4)
      ++result.report.x_vertices;
  }
  return straight;
}

[[noreturn]] void refuse(const CutRequest& request, const CutFault& fault) {
  throw CutError(CutError::Kind::certificate, fault.fault, fault.place,
                 request.emin > 0.0 && request.amin > 0.0
                     ? "give larger emin and amin, or remove one of two joints that "
                       "nearly coincide there"
                     : "give emin and amin, such as 1e-6 of the size of a block");
}

// Marks the edges of these joints, and their vertices.
void protect(CutGraph& graph, const std::vector<int>& joints) {
  if (joints.empty())
    return;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    CutGraph::Edge& edge = graph.edges[e];
    edge.is_protected = edge.alive && std::find(joints.begin(), joints.end(),
                                                edge.joint) != joints.end();
    if (edge.is_protected)
      for (const std::size_t h : {2 * e, 2 * e + 1})
        graph.vertices[at(graph.origin[h])].is_protected = true;
  }
}

// Cleans and certifies the cells of a graph. repair: edges up to this length, [L], are
// contracted in any case. part: what the work takes of the progress.
CutResult cleaned(const CutRequest& request, CutGraph graph, const Lines& lines,
                  const CutReport& report, double repair,
                  const std::pair<double, double>& part) {
  const double middle = part.first + (part.second - part.first) / 3.0;
  CutResult result;
  result.report = report;
  clean(graph, lines, {std::max(request.emin, repair), request.amin, repair},
        result.report,
        StepProgress(request.progress, "clean cells", part.first, middle));
  StepProgress making(request.progress, "certify cells", middle,
                      middle + 0.2 * (part.second - middle));
  const StraightCorners straight = fill_mesh(graph, lines, result, making);
  make_blocks(result, straight,
              StepProgress(request.progress, "certify cells",
                           middle + 0.2 * (part.second - middle), part.second));
  result.report.kept_short = short_sides(result, request.emin);
  return result;
}

// Lengths of edges, in units in the last place of the largest coordinate, that are
// contracted one after the other until the certificate holds. Rounding moves a vertex
// by one unit, so the cells that it destroys have edges or widths of a few units.
// Larger values would refuse fewer domains, but move vertices farther than asked for.
constexpr std::array<double, 3> repair_units = {4.0, 64.0, 1024.0};

double largest_unit(const std::vector<Vec2>& corners) {
  double largest = 0.0;
  for (const Vec2& corner : corners)
    largest = std::max(largest, corner.lpNorm<Eigen::Infinity>());
  return std::nextafter(largest, HUGE_VAL) - largest;
}

using EdgeLengths = std::vector<std::pair<int, double>>;  // joint id, length

// Returns the sum for each joint id. The lengths are added in the order of their
// values, because that of the edges depends on the order of the joints.
std::map<int, double> sums(const EdgeLengths& edges, StepProgress& progress) {
  std::map<int, std::vector<double>> lengths;
  for (const auto& [joint, length] : edges)
    lengths[joint].push_back(length);
  std::map<int, double> result;
  for (auto& [joint, list] : lengths) {
    std::sort(list.begin(), list.end(), [&progress](double a, double b) {
      progress.count(1, 1);
      return a < b;
    });
    result[joint] = std::accumulate(list.begin(), list.end(), 0.0);
  }
  return result;
}

// Prunes the graph and reports the lengths of the joints.
void prune(CutGraph& graph, double area, CutReport& report, StepProgress& progress) {
  EdgeLengths drawn, pruned, kept;
  std::vector<std::size_t> inner;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    progress.count(0, 1);
    if (graph.edges[e].alive && !graph.edges[e].outline) {
      inner.push_back(e);
      drawn.emplace_back(graph.edges[e].joint, graph.length(e));
    }
  }
  keep_separating_edges(graph, report, progress);
  for (std::size_t i = 0; i < inner.size(); ++i)
    (graph.edges[inner[i]].alive ? kept : pruned).push_back(drawn[i]);
  for (const auto& [joint, length] : sums(drawn, progress)) {
    report.lengths[joint].drawn = length;
    report.p21_before += length / area;
  }
  for (const auto& [joint, length] : sums(pruned, progress))
    report.lengths[joint].pruned = length;
  for (const auto& [joint, length] : sums(kept, progress))
    report.p21_after += length / area;
}

}  // namespace

CutResult cut_outline(const CutRequest& request) {
  const RoundToNearest mode;
  const std::vector<Point> outline = exact_outline(request);
  const std::vector<Vec2> corners = rounded_corners(request);
  check_request(request, outline, corners);
  const double area = section_properties(corners).area;

  CutReport report;
  exact::JointArrangement arrangement =
      exact::arrange_joints(outline, request.joints, request.progress);
  StepProgress pruning(request.progress, "prune joints", 0.6, 0.7);
  prune(arrangement.graph, area, report, pruning);
  report.straight_vertices =
      join_straight_edges(arrangement.graph, arrangement.lines, pruning);
  CutGraph graph =
      round_vertices(arrangement, outline, corners,
                     StepProgress(request.progress, "round vertices", 0.7, 0.8));
  arrangement.graph = {};
  StepProgress numbering(request.progress, "round vertices", 0.8, 0.8);
  graph.number_cells(numbering);
  protect(graph, request.protected_joints);
  CutResult result =
      cleaned(request, graph, arrangement.lines, report, 0.0, {0.8, 0.95});
  StepProgress proving(request.progress, "certify cells", 0.95, 0.95);
  std::optional<CutFault> fault = find_fault(result, request, proving);
  // Where rounding has destroyed cells, very short edges are contracted as well.
  double begin = 0.95;
  const double unit = largest_unit(corners);
  for (const double units : repair_units) {
    const double emin = units * unit;
    const bool is_done = emin <= request.emin && request.protected_joints.empty();
    if (!fault || is_done || !(emin * emin < area / 16.0))
      continue;
    CutResult again =
        cleaned(request, graph, arrangement.lines, report, emin, {begin, begin + 0.01});
    begin += 0.01;
    StepProgress proving_again(request.progress, "certify cells", begin, begin);
    if (!find_fault(again, request, proving_again)) {
      fault.reset();
      result = std::move(again);
      result.report.repaired_below = emin;
    }
  }
  if (fault)
    refuse(request, *fault);
  return result;
}

}  // namespace blocks::geometry
