// Preconditions of CGAL's multiset compare after a node was allocated. The node would
// leak if a report of progress throws there.
#define CGAL_MULTISET_NO_PRECONDITIONS

#include "geometry/exact/joint_arrangement.hpp"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <utility>

#include "geometry/exact/joint_pieces.hpp"
#include "geometry/exact/watched_sweep.hpp"

namespace blocks::geometry::exact {
namespace {

// Lazy numbers compute an exact coordinate only if its interval cannot decide.
using Lazy = CGAL::Exact_predicates_exact_constructions_kernel;

// What an edge of the arrangement belongs to.
struct Source {
  int segment = 0;
  int joint = 0;
  bool outline = false;
  bool operator==(const Source&) const = default;
};

// Joints on the outline separate no blocks there, so it has no joint id.
struct MergeSources {
  Source operator()(const Source& a, const Source& b) const {
    const bool outline = a.outline || b.outline;
    return {std::min(a.segment, b.segment),
            outline ? 0 : common_joint(a.joint, b.joint), outline};
  }
};

using Segments = WatchedSegments<Lazy>;
using Traits = CGAL::Arr_curve_data_traits_2<Segments, Source, MergeSources>;
// Vertices and half-edges have numbers. A face has 1 if it is outside of the outline.
using Dcel = CGAL::Arr_extended_dcel<Traits, int, int, int>;
using Arrangement = CGAL::Arrangement_2<Traits, Dcel>;

Lazy::FT lazy(const Rational& value) {
  const double rounded = nearest(value);
  if (value == Rational(rounded))
    return {rounded};
  return {Lazy::Exact_kernel::FT(value.mpq())};
}

// CGAL uses the rationals of GMP's C++ interface or those of Boost.
template <typename Number> mpq_srcptr rational_of(const Number& value) {
  if constexpr (requires { value.get_mpq_t(); })
    return value.get_mpq_t();
  else
    return value.backend().data();
}

Rational rational(const Lazy::Exact_kernel::FT& value) {
  Rational copy;
  mpq_set(copy.mpq(), rational_of(value));
  return copy;
}

Lazy::Point_2 lazy(const Point& p) { return {lazy(p.x()), lazy(p.y())}; }

// Calls visit(half-edge) for all half-edges around the face.
template <typename Visit> void for_each_side(Arrangement::Face& face, Visit visit) {
  const auto around = [&visit](Arrangement::Ccb_halfedge_circulator first) {
    auto turn = first;
    do {
      visit(*turn);
    } while (++turn != first);
  };
  for (auto ccb = face.outer_ccbs_begin(); ccb != face.outer_ccbs_end(); ++ccb)
    around(*ccb);
  for (auto ccb = face.inner_ccbs_begin(); ccb != face.inner_ccbs_end(); ++ccb)
    around(*ccb);
}

// Marks the faces that are connected to the unbounded one without crossing the outline.
void mark_outside(Arrangement& arrangement, StepProgress& progress) {
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face)
    face->set_data(0);
  std::vector<Arrangement::Face_handle> open = {arrangement.unbounded_face()};
  open.front()->set_data(1);
  while (!open.empty()) {
    const Arrangement::Face_handle face = open.back();
    open.pop_back();
    for_each_side(*face, [&open, &progress](Arrangement::Halfedge& side) {
      progress.count(0, 1);
      const Arrangement::Face_handle other = side.twin()->face();
      if (side.curve().data().outline || other->data() != 0)
        return;
      other->set_data(1);
      open.push_back(other);
    });
  }
}

// Fills what is known about a vertex from the edges around it.
void describe_vertex(const Arrangement::Vertex& from, JointArrangement& result,
                     int sides, CutGraph::Vertex& vertex) {
  const std::vector<Line>& lines = result.lines;
  auto turn = from.incident_halfedges();
  const auto first = turn;
  do {
    const Source& source = turn->curve().data();
    if (source.outline) {
      const int side = source.segment;
      if (vertex.side >= 0 && vertex.side != side)
        vertex.corner = (side + 1) % sides == vertex.side ? vertex.side : side;
      vertex.side = vertex.side < 0 ? side : std::min(vertex.side, side);
    }
    if (vertex.first < 0)
      vertex.first = source.segment;
    else if (vertex.second < 0 && source.segment != vertex.first &&
             !parallel(lines[CutGraph::at(source.segment)],
                       lines[CutGraph::at(vertex.first)]))
      vertex.second = source.segment;
  } while (++turn != first);
  if (vertex.second < 0) {
    const auto& exactly = from.point().exact();
    const Point point(rational(exactly.x()), rational(exactly.y()));
    vertex.place = nearest(point);
    if (from.degree() > 1) {  // others are pruned
      vertex.point = static_cast<int>(result.points.size());
      result.points.push_back(point);
    }
  } else {
    vertex.place = intersection(lines[CutGraph::at(vertex.first)],
                                lines[CutGraph::at(vertex.second)])
                       .nearest();
  }
}

// Copies the edges that have the inside of the outline on at least one side. Requires
// the lines.
void copy_inside(Arrangement& arrangement, int sides, JointArrangement& result,
                 StepProgress& progress) {
  CutGraph& graph = result.graph;
  graph.vertices.reserve(arrangement.number_of_vertices());
  graph.edges.reserve(arrangement.number_of_edges());
  for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) {
    progress.count(graph.vertices.size(), 2 * arrangement.number_of_vertices());
    v->set_data(static_cast<int>(graph.vertices.size()));
    if (!v->is_isolated())
      describe_vertex(*v, result, sides, graph.vertices.emplace_back());
  }
  for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e) {
    progress.count(1, 2);
    const auto number = static_cast<int>(2 * graph.edges.size());
    e->set_data(number);
    e->twin()->set_data(number + 1);
    const Source& source = e->curve().data();
    graph.edges.push_back({source.segment, source.joint, source.outline, true});
  }
  const std::size_t half_edges = 2 * graph.edges.size();
  graph.origin.resize(half_edges);
  graph.next.resize(half_edges);
  graph.previous.resize(half_edges);
  graph.cell.resize(half_edges);
  std::vector<std::size_t> outside;
  for (auto h = arrangement.halfedges_begin(); h != arrangement.halfedges_end(); ++h) {
    progress.count(1, 2);
    const std::size_t i = CutGraph::at(h->data());
    graph.origin[i] = h->source()->data();
    graph.next[i] = h->next()->data();
    graph.previous[i] = h->prev()->data();
    graph.cell[i] = h->face()->data() != 0 ? -1 : 0;
    graph.vertices[CutGraph::at(graph.origin[i])].half_edge = static_cast<int>(i);
    if (i % 2 == 0 && h->face()->data() != 0 && h->twin()->face()->data() != 0)
      outside.push_back(i / 2);
  }
  for (const std::size_t e : outside)
    graph.remove_edge(e);
}

// The least and the greatest x of all ends, at most as far as pieces of joints reach.
std::pair<double, double> range_in_x(const std::vector<Point>& outline,
                                     const std::vector<JointSegment>& joints) {
  double low = nearest(outline[0].x()), high = low;
  const auto include = [&](double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  };
  for (const Point& corner : outline)
    include(nearest(corner.x()));
  constexpr double most = 4.0 * largest_coordinate;
  for (const JointSegment& joint : joints) {
    include(std::clamp(joint.from.nearest().x(), -most, most));
    include(std::clamp(joint.to.nearest().x(), -most, most));
  }
  return {low, high};
}

}  // namespace

JointArrangement arrange_joints(const std::vector<Point>& outline,
                                const std::vector<JointSegment>& joints,
                                const ProgressFunction& progress) {
  JointArrangement result;
  StepProgress reading(progress, "arrange joints", 0.0, 0.02);
  result.lines.reserve(outline.size() + joints.size());
  std::vector<Traits::X_monotone_curve_2> curves;
  curves.reserve(outline.size() + joints.size());
  const auto add = [&](const Point& p, const Point& q, Line line, int joint,
                       bool is_outline) {
    const auto segment = static_cast<int>(result.lines.size());
    result.lines.push_back(std::move(line));
    curves.emplace_back(Segments::X_monotone_curve_2(lazy(p), lazy(q)),
                        Source{segment, joint, is_outline});
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &p = outline[i], &q = outline[(i + 1) % outline.size()];
    add(p, q, Line(p, q), 0, true);
  }
  for (JointPiece& piece : joint_pieces(joints)) {
    reading.count(result.lines.size(), joints.size());
    add(piece.from, piece.to, std::move(piece.line), piece.joint, false);
  }
  StepProgress sweeping(progress, "arrange joints", 0.02, 0.5);
  const auto [low, high] = range_in_x(outline, joints);
  SweepWatch watch(sweeping, low, high);
  Traits traits;
  traits.watch = &watch;
  Arrangement arrangement(&traits);
  insert_watched(arrangement, curves);
  traits.watch = nullptr;
  StepProgress copying(progress, "arrange joints", 0.5, 0.6);
  mark_outside(arrangement, copying);
  copy_inside(arrangement, static_cast<int>(outline.size()), result, copying);
  return result;
}

}  // namespace blocks::geometry::exact
