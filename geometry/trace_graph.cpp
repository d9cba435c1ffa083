#include "geometry/trace_graph.hpp"

#include <CGAL/Polygon_2_algorithms.h>

#include "geometry/exact/joint_arrangement.hpp"
#include "geometry/exact/shared_point.hpp"
#include "geometry/numeric_environment.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

using exact::Point;

// Returns the exact corners, or throws if they are no simple clockwise window.
std::vector<Point> exact_window(const std::vector<DecimalPoint>& window) {
  Polygon nearest;
  std::vector<Point> corners;
  for (const DecimalPoint& corner : window) {
    nearest.emplace_back(corner.x.value(), corner.y.value());
    corners.push_back(exact::rational(corner));
  }
  const OutlineCheck check = check_outline(nearest);
  const auto refuse = [&](const std::string& message, const std::string& hint) {
    const auto at = static_cast<std::size_t>(std::max(check.first, 0));
    throw CutError(CutError::Kind::outline, message,
                   nearest.empty() ? Vec2(0.0, 0.0) : nearest[at % nearest.size()],
                   hint);
  };
  if (check.fault != OutlineFault::none)
    refuse("the window is not simple: " + describe(check),
           "give at least three corners in order, each one once");
  for (const Vec2& corner : nearest)
    if (!(corner.cwiseAbs().maxCoeff() <= largest_coordinate))
      refuse("a corner is too far away to calculate with",
             "choose another unit of length");
  if (check.anticlockwise)
    refuse("the window is anticlockwise", "give the corners clockwise");
  if (!CGAL::is_simple_2(corners.begin(), corners.end(), exact::Kernel()))
    refuse("the window is not simple before rounding", "move corners apart");
  return corners;
}

}  // namespace

TraceGraph trace_graph(const std::vector<DecimalPoint>& window,
                       const std::vector<JointSegment>& segments,
                       const ProgressFunction& progress) {
  const RoundToNearest mode;
  const std::vector<Point> corners = exact_window(window);
  for (const JointSegment& one : segments)
    for (const Vec2& end : {one.from.nearest(), one.to.nearest()})
      if (!end.allFinite())
        throw CutError(CutError::Kind::joint, "a trace has an end that is not finite",
                       {0.0, 0.0}, "give finite coordinates");
  const CutGraph graph = exact::arrange_joints(corners, segments, progress).graph;
  TraceGraph result;
  std::vector<int> number(graph.vertices.size(), -1);
  const auto node = [&](int vertex) {
    const std::size_t v = CutGraph::at(vertex);
    if (number[v] < 0) {
      number[v] = static_cast<int>(result.nodes.size());
      result.nodes.push_back({graph.vertices[v].place, 0, graph.vertices[v].side >= 0});
    }
    ++result.nodes[CutGraph::at(number[v])].degree;
    return number[v];
  };
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const CutGraph::Edge& edge = graph.edges[e];
    if (edge.alive && !edge.outline)
      result.edges.push_back({node(graph.origin[2 * e]), node(graph.origin[2 * e + 1]),
                              edge.joint, graph.length(e)});
  }
  return result;
}

}  // namespace blocks::geometry
