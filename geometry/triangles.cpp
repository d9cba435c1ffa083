#include "geometry/triangles.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

#include "geometry/convex_parts.hpp"
#include "geometry/exact/kernels.hpp"

namespace blocks::geometry {
namespace {

using NumberedVertex =
    CGAL::Triangulation_vertex_base_with_info_2<int, exact::Filtered>;
using NumberedVertices = CGAL::Triangulation_data_structure_2<
    NumberedVertex, CGAL::Triangulation_face_base_2<exact::Filtered>>;
using Triangulation = CGAL::Delaunay_triangulation_2<exact::Filtered, NumberedVertices>;

}  // namespace

// The hull of the corners of a convex part is the part, also if it has straight
// corners. So all finite faces of their triangulation are inside.
std::vector<std::array<int, 3>> triangles(const Polygon& outline) {
  std::vector<std::array<int, 3>> found;
  for (const std::vector<int>& part : convex_parts(outline)) {
    std::vector<std::pair<exact::Filtered::Point_2, int>> corners;
    for (const int c : part)
      corners.emplace_back(exact::point(outline[static_cast<std::size_t>(c)]), c);
    const Triangulation triangulation(corners.begin(), corners.end());
    for (const auto& face : triangulation.finite_face_handles())  // anticlockwise
      found.push_back(
          {face->vertex(0)->info(), face->vertex(2)->info(), face->vertex(1)->info()});
  }
  return found;
}

}  // namespace blocks::geometry
