#include "geometry/cut_certificate.hpp"

#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/exact/kernels.hpp"
#include "geometry/exact/numbers.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Points on slanted sides are rounded into the domain by about one unit. The largest
// distance is that of layers, so that both may share a side.
constexpr double max_units_inside = 64.0;

// A side of the requested outline.
struct RequestedSide {
  Vec2 from, to;
  bool horizontal, vertical;  ///< before and after rounding
  double depth;               ///< [L] largest distance of a point on it
};

std::vector<RequestedSide> requested_sides(const CutRequest& request,
                                           const std::vector<Vec2>& corners) {
  std::vector<exact::Point> exactly;
  double largest = 0.0;
  for (const DecimalPoint& corner : request.outline)
    exactly.push_back(exact::rational(corner));
  for (const Vec2& corner : corners)
    largest = std::max(largest, corner.lpNorm<Eigen::Infinity>());
  const double unit = std::nextafter(largest, HUGE_VAL) - largest;
  const auto moved = [&](std::size_t i) {
    return (corners[i] - exact::nearest(exactly[i])).norm();
  };
  std::vector<RequestedSide> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t j = (i + 1) % corners.size();
    const Vec2 &from = corners[i], &to = corners[j];
    sides.push_back({from, to, exactly[i].y() == exactly[j].y() && from.y() == to.y(),
                     exactly[i].x() == exactly[j].x() && from.x() == to.x(),
                     max_units_inside * unit + std::max(moved(i), moved(j))});
  }
  return sides;
}

double distance(const RequestedSide& side, const Vec2& p) {
  const Vec2 along = side.to - side.from, out = p - side.from;
  const double position = along.dot(out);
  if (position <= 0.0)
    return out.norm();
  if (position >= along.squaredNorm())
    return (p - side.to).norm();
  return std::abs(cross(along, out)) / along.norm();
}

// Tests whether q is farther along the side than p.
bool is_farther(const RequestedSide& side, const Vec2& p, const Vec2& q) {
  return CGAL::angle(exact::point(side.from), exact::point(side.to), exact::point(p),
                     exact::point(q)) == CGAL::ACUTE;
}

bool is_on(const RequestedSide& side, const Vec2& p) {
  if (side.horizontal || side.vertical)
    return (side.horizontal ? p.y() == side.from.y() : p.x() == side.from.x()) &&
           is_farther(side, p, side.to);
  // The domain is on the right of its clockwise sides.
  return CGAL::orientation(exact::point(side.from), exact::point(side.to),
                           exact::point(p)) != CGAL::LEFT_TURN &&
         distance(side, p) <= side.depth;
}

// The areas of the cells add up to that of their common outline, exactly.
bool areas_add_up(const Mesh& mesh, StepProgress& progress) {
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
  for (const std::vector<int>& cell : mesh.cells) {
    progress.count(1, 1);
    rest = rest - twice(cell);
  }
  return CGAL::sign(rest) == CGAL::ZERO;
}

// Names what made a side of a cell.
std::string source_of(const CutResult& result, std::size_t cell, std::size_t side) {
  const std::vector<int>& loop = result.mesh.cells[cell];
  const std::vector<int>& outline = result.mesh.outline;
  const int id = result.joints[cell][side];
  if (id > 0)
    return "joint " + std::to_string(id);
  const auto from = std::find(outline.begin(), outline.end(), loop[side]);
  if (from == outline.end())
    return "a joint without an id";
  const int to = from + 1 == outline.end() ? outline.front() : *(from + 1);
  return to == loop[(side + 1) % loop.size()] ? "the outline" : "a joint without an id";
}

// Returns a point on both sides up to rounding, or between them.
Vec2 common_place(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double area = cross(b - a, d - c);
  const double part = area == 0.0 ? 0.5 : cross(c - a, d - c) / area;
  return a + std::clamp(part, 0.0, 1.0) * (b - a);
}

CutFault cell_fault(const CutResult& result) {
  const Mesh& mesh = result.mesh;
  if (result.certificate.offending_cells.empty())
    return {result.certificate.fault,
            mesh.vertices.empty() ? Vec2(0.0, 0.0) : mesh.vertices[0]};
  const std::size_t cell = at(result.certificate.offending_cells[0]);
  Polygon polygon;
  for (const int v : mesh.cells[cell])
    polygon.push_back(mesh.vertices[at(v)]);
  const OutlineCheck check = check_outline(polygon);
  const std::size_t n = polygon.size();
  const std::size_t first = at(std::max(check.first, 0)),
                    second = check.second < 0 ? (first + n - 1) % n : at(check.second);
  CutFault fault{"", polygon[first]};
  if (check.fault == OutlineFault::self_crossing)
    fault.place = common_place(polygon[first], polygon[(first + 1) % n],
                               polygon[second], polygon[(second + 1) % n]);
  if (check.fault == OutlineFault::none && !check.anticlockwise) {
    fault.fault = result.certificate.fault;
    return fault;
  }
  std::string one = source_of(result, cell, first),
              other = source_of(result, cell, second);
  if (other < one)
    std::swap(one, other);
  fault.fault = "a cell " +
                (one == other ? "at " + one : "between " + one + " and " + other) +
                " is thinner than doubles can represent";
  return fault;
}

}  // namespace

std::vector<Vec2> rounded_corners(const CutRequest& request) {
  if (request.rounded)
    return *request.rounded;
  std::vector<Vec2> corners;
  for (const DecimalPoint& corner : request.outline)
    corners.push_back(exact::nearest(exact::rational(corner)));
  return corners;
}

std::optional<CutFault> outline_deviation(const Mesh& mesh, const CutRequest& request) {
  const std::vector<Vec2> corners = rounded_corners(request);
  const auto missing = [&](std::size_t corner) {
    return CutFault{"corner " + std::to_string(corner + 1) +
                        " of the outline is missing",
                    corners[corner]};
  };
  const auto place = [&](std::size_t i) -> const Vec2& {
    return mesh.vertices[at(mesh.outline[i])];
  };
  const std::size_t n = mesh.outline.size();
  if (n == 0 || place(0) != corners[0])
    return missing(0);
  std::size_t i = 1;
  const std::vector<RequestedSide> sides = requested_sides(request, corners);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const RequestedSide& side = sides[s];
    const bool is_last = s + 1 == sides.size();
    for (Vec2 before = side.from; i < n && (is_last || place(i) != side.to); ++i) {
      const Vec2& p = place(i);
      // A point on a slanted side may be rounded past the end of that side.
      const bool is_first = before == side.from && !side.horizontal && !side.vertical;
      if (!is_on(side, p) || !(is_first || is_farther(side, before, p)))
        return CutFault{
            "a point of the outline is not on side " + std::to_string(s + 1), p};
      before = p;
    }
    if (is_last)
      break;
    if (i == n)
      return missing(s + 1);
    ++i;  // the corner
  }
  return std::nullopt;
}

std::optional<CutFault> find_fault(const CutResult& result, const CutRequest& request,
                                   StepProgress& progress) {
  if (!result.certificate.holds)
    return cell_fault(result);
  if (const auto deviation = outline_deviation(result.mesh, request))
    return deviation;
  if (!areas_add_up(result.mesh, progress))
    return CutFault{"the areas of the cells do not add up", result.mesh.vertices[0]};
  return std::nullopt;
}

}  // namespace blocks::geometry
