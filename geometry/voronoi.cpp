#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "geometry/exact/shared_point.hpp"
#include "geometry/joint_sources.hpp"
#include "geometry/numeric_environment.hpp"
#include "geometry/polygon.hpp"
#include "geometry/region.hpp"

namespace blocks::geometry {
namespace {

using exact::Point;
using exact::Rational;
using exact::Vector;

using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<std::size_t, exact::Filtered>;
using FaceBase = CGAL::Triangulation_face_base_2<exact::Filtered>;
using Delaunay = CGAL::Delaunay_triangulation_2<
    exact::Filtered, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

[[noreturn]] void refuse(const std::string& message, const Vec2& place,
                         const std::string& hint) {
  throw CutError(CutError::Kind::generator, message, place, hint);
}

Polygon rounded(const std::vector<DecimalPoint>& outline) {
  Polygon polygon;
  for (const DecimalPoint& corner : outline)
    polygon.emplace_back(corner.x.value(), corner.y.value());
  return polygon;
}

std::vector<Vec2> random_points(const VoronoiRequest& request, const Polygon& outline,
                                StepProgress progress) {
  const Region region(outline);
  Vec2 low = outline[0], high = outline[0];
  for (const Vec2& corner : outline) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  // A point outside of the outline is drawn again, at most so many times.
  constexpr std::uint32_t max_draws = 100'000;
  std::vector<Vec2> points;
  for (int i = 0; i < request.count; ++i)
    for (std::uint32_t draw = 0;; ++draw) {
      if (draw == max_draws)
        refuse("no random points are in the outline", outline[0],
               "give points, or an outline that fills more of its bounding box");
      progress.count(points.size(), static_cast<std::size_t>(request.count));
      const auto part = [&](std::uint32_t use) {
        return (static_cast<double>(random_53_bits(
                    request.stream, static_cast<std::uint64_t>(i), draw, use)) +
                0.5) *
               0x1p-53;
      };
      const Vec2 p(low.x() + part(0) * (high.x() - low.x()),
                   low.y() + part(1) * (high.y() - low.y()));
      if (!region.contains(p))
        continue;
      points.push_back(p);
      break;
    }
  return points;
}

// The points without repeated ones, in their order.
std::vector<Vec2> distinct(const std::vector<Vec2>& points) {
  std::set<std::pair<double, double>> met;
  std::vector<Vec2> kept;
  for (const Vec2& p : points)
    if (met.emplace(p.x(), p.y()).second)
      kept.push_back(p);
  return kept;
}

Delaunay triangulation_of(const std::vector<Vec2>& points, StepProgress& progress) {
  std::vector<exact::Filtered::Point_2> sites;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sites.push_back(exact::point(points[i]));
    order.push_back(i);
  }
  using Places = CGAL::Pointer_property_map<exact::Filtered::Point_2>::type;
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<exact::Filtered, Places>(
                         CGAL::make_property_map(sites)));
  Delaunay delaunay;
  Delaunay::Face_handle near;
  std::size_t done = 0;
  for (const std::size_t i : order) {
    progress.count(done++, 2 * order.size());
    const Delaunay::Vertex_handle vertex = delaunay.insert(sites[i], near);
    vertex->info() = i;
    near = vertex->face();
  }
  return delaunay;
}

// The part of the polygon on the side of `own` of the bisector to `other` (Sutherland
// and Hodgman), in doubles. Bridges of a concave outline have no area.
Polygon nearer(const Polygon& polygon, const Vec2& own, const Vec2& other) {
  const Vec2 normal = other - own, middle = own + normal / 2.0;
  const auto side = [&](const Vec2& p) { return normal.dot(p - middle); };
  Polygon rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &here = polygon[i], &then = polygon[(i + 1) % polygon.size()];
    const double d = side(here), e = side(then);
    if (d <= 0.0)
      rest.push_back(here);
    if ((d < 0.0 && e > 0.0) || (d > 0.0 && e < 0.0))
      rest.emplace_back(here + (then - here) * (d / (d - e)));
  }
  return rest;
}

// One round of Lloyd's relaxation: moves points to the centroids of their cells.
std::vector<Vec2> relaxed(const std::vector<Vec2>& points, const Polygon& outline,
                          StepProgress progress) {
  const Region region(outline);
  const Delaunay delaunay = triangulation_of(points, progress);
  std::vector<Vec2> moved = points;
  std::size_t done = points.size();
  for (auto v = delaunay.finite_vertices_begin(); v != delaunay.finite_vertices_end();
       ++v) {
    progress.count(done++, 2 * points.size());
    const Vec2& own = points[v->info()];
    // The order of the neighbours is fixed, so that the bits are the same everywhere.
    std::vector<std::size_t> neighbours;
    auto turn = delaunay.incident_vertices(v);
    if (turn != nullptr) {
      const auto first = turn;
      do {
        if (!delaunay.is_infinite(turn))
          neighbours.push_back(turn->info());
      } while (++turn != first);
    }
    std::sort(neighbours.begin(), neighbours.end());
    Polygon cell = outline;
    for (const std::size_t other : neighbours)
      cell = nearer(cell, own, points[other]);
    if (cell.size() < 3)
      continue;
    const SectionProperties properties = section_properties(cell);
    if (properties.area > 0.0 && region.contains(properties.centroid))
      moved[v->info()] = properties.centroid;
  }
  return moved;
}

Point exactly(const exact::Filtered::Point_2& p) {
  return {Rational(p.x()), Rational(p.y())};
}

// Makes the edges of the cells. Edges to infinity end outside of the box.
class Cells {
 public:
  Cells(const Delaunay& delaunay, const Polygon& outline, int id)
      : delaunay_(delaunay), id_(id) {
    Vec2 low = outline[0], high = outline[0];
    const auto include = [&](const Vec2& p) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    };
    for (const Vec2& corner : outline)
      include(corner);
    for (auto v = delaunay.finite_vertices_begin(); v != delaunay.finite_vertices_end();
         ++v)
      include({v->point().x(), v->point().y()});
    middle_ = (low + high) / 2.0;
    radius_ = (high - low).norm() + 0x1p-40 * middle_.lpNorm<Eigen::Infinity>();
  }

  std::vector<JointSegment> edges(StepProgress& progress) {
    std::vector<JointSegment> result;
    for (auto e = delaunay_.finite_edges_begin(); e != delaunay_.finite_edges_end();
         ++e) {
      progress.count(1, 2);
      const auto face = e->first;
      const Point p = exactly(face->vertex(Delaunay::ccw(e->second))->point());
      const Point q = exactly(face->vertex(Delaunay::cw(e->second))->point());
      if (delaunay_.dimension() == 1) {
        const Point m = CGAL::midpoint(p, q);
        add(exact::nearest(far_from(m, q - p)), exact::nearest(far_from(m, p - q)),
            result);
        continue;
      }
      const auto other = face->neighbor(e->second);
      const bool left = !delaunay_.is_infinite(face),
                 right = !delaunay_.is_infinite(other);
      // p -> q has the face on its left, so the other face is on the right.
      const Vec2 from =
          left ? end_at(face, p, q)
               : exact::nearest(far_from(base(other, p, q), reversed(q - p)));
      const Vec2 to = right ? end_at(other, p, q)
                            : exact::nearest(far_from(base(face, p, q), q - p));
      add(from, to, result);
    }
    // The order of CGAL's edges depends on the places of faces in memory.
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
      return a.from.nearest() != b.from.nearest()
                 ? is_before(a.from.nearest(), b.from.nearest())
                 : is_before(a.to.nearest(), b.to.nearest());
    });
    return result;
  }

 private:
  static bool is_before(const Vec2& p, const Vec2& q) {
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  }
  static Vector reversed(const Vector& v) { return {-v.x(), -v.y()}; }
  static Point exact_centre(Delaunay::Face_handle face) {
    return CGAL::circumcenter(exactly(face->vertex(0)->point()),
                              exactly(face->vertex(1)->point()),
                              exactly(face->vertex(2)->point()));
  }
  const Vec2& centre(Delaunay::Face_handle face) {
    auto [found, is_new] = centres_.try_emplace(&*face);
    if (is_new)
      found->second = exact::nearest(exact_centre(face));
    return found->second;
  }
  bool is_near(Delaunay::Face_handle face) {
    return centre(face).lpNorm<Eigen::Infinity>() <= largest_coordinate;
  }
  // A point of the edge between the cells of p and q, at the centre of a face if that
  // is not too far away.
  Point base(Delaunay::Face_handle face, const Point& p, const Point& q) {
    return is_near(face) ? exact_centre(face) : CGAL::midpoint(p, q);
  }
  // The end of the edge between the cells of p and q at the centre of a face. A centre
  // that is too far away is replaced by a nearer point of the edge outside of the box.
  Vec2 end_at(Delaunay::Face_handle face, const Point& p, const Point& q) {
    if (is_near(face))
      return centre(face);
    const Point m = CGAL::midpoint(p, q);
    const bool is_right = exact::cross(q - p, exact_centre(face) - m) < 0;
    return exact::nearest(far_from(m, is_right ? q - p : p - q));
  }
  // A point outside of the box, from p on the right of the direction.
  Point far_from(const Point& p, const Vector& direction) const {
    const Vec2 d(exact::nearest(direction.x()), exact::nearest(direction.y()));
    const double reach = (exact::nearest(p) - middle_).norm() + 2.0 * radius_;
    constexpr double min = 0x1p-500;  // squares of lesser lengths are no doubles
    const Rational factor =
        d.norm() > min ? Rational(std::exp2(std::ceil(std::log2(reach / d.norm()))))
                       : Rational(reach) /
                             std::max<Rational>(abs(direction.x()), abs(direction.y()));
    return {p.x() + direction.y() * factor, p.y() - direction.x() * factor};
  }
  void add(const Vec2& from, const Vec2& to, std::vector<JointSegment>& result) const {
    if (from != to)  // points on one circle share a vertex
      result.push_back(
          {is_before(from, to) ? from : to, is_before(from, to) ? to : from, id_});
  }

  const Delaunay& delaunay_;
  int id_;
  Vec2 middle_;
  double radius_ = 0.0;
  std::map<const Delaunay::Face*, Vec2> centres_;
};

}  // namespace

VoronoiCells voronoi_cells(const VoronoiRequest& request,
                           const std::vector<DecimalPoint>& outline,
                           const ProgressFunction& progress) {
  const RoundToNearest mode;
  const Polygon corners = rounded(outline);
  const Vec2 place = corners.empty() ? Vec2(0.0, 0.0) : corners[0];
  if (corners.size() < 3)
    refuse("the outline has fewer than three corners", place, "give an outline first");
  if (request.id < 0 || request.lloyd < 0)
    refuse("the joint id or the number of rounds is negative", place, "give 0 or more");
  if (request.points.empty() &&
      (request.count < 1 || request.count > static_cast<int>(max_joint_pieces)))
    refuse("the number of points is not between 1 and 1e7", place,
           "give a number of points, or the points");
  for (const Vec2& p : request.points)
    if (!p.allFinite())
      refuse("a point is not finite", place, "give finite coordinates");
    else if (p.lpNorm<Eigen::Infinity>() > largest_coordinate)
      refuse("a point is too far away to calculate with", p,
             "remove it, or choose another unit of length");
  VoronoiCells cells;
  // The rounds of relaxation, the points and the cells share the work evenly.
  const double steps = 2.0 + request.lloyd;
  double step = 0.0;
  const auto next = [&](const char* name) {
    step += 1.0;
    return StepProgress(progress, name, (step - 1.0) / steps, step / steps);
  };
  StepProgress drawing = next("draw points");
  cells.points = request.points.empty() ? random_points(request, corners, drawing)
                                        : distinct(request.points);
  for (int round = 0; round < request.lloyd; ++round)
    cells.points = relaxed(cells.points, corners, next("relax points"));
  StepProgress making = next("make cells");
  const Delaunay delaunay = triangulation_of(cells.points, making);
  cells.edges = Cells(delaunay, corners, request.id).edges(making);
  return cells;
}

}  // namespace blocks::geometry
