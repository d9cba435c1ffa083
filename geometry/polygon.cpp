#include "geometry/polygon.hpp"

#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/exact/kernels.hpp"
#include "geometry/exact/numbers.hpp"

namespace blocks::geometry {
namespace {

using exact::Filtered;
using Points = std::vector<Filtered::Point_2>;

// Above this number of corners the sweep of CGAL runs first. Below, testing pairs of
// sides is faster.
constexpr std::size_t many_corners = 200;

std::size_t next(const Points& p, std::size_t i) { return (i + 1) % p.size(); }
std::size_t previous(const Points& p, std::size_t i) {
  return (i + p.size() - 1) % p.size();
}

CGAL::Orientation turn(const Points& p, std::size_t i) {
  return CGAL::orientation(p[previous(p, i)], p[i], p[next(p, i)]);
}

OutlineCheck fault_at(OutlineFault fault, std::size_t first, std::size_t second) {
  OutlineCheck check;
  check.fault = fault;
  check.first = static_cast<int>(std::min(first, second));
  check.second = static_cast<int>(std::max(first, second));
  return check;
}

// Tests whether the outline is strictly convex and winds once. All turns then have the
// same sign, and the corners run once to the right and once to the left. This decides
// the common case without testing pairs of sides.
bool strictly_convex(const Points& p) {
  const CGAL::Orientation sense = turn(p, 0);
  if (sense == CGAL::COLLINEAR)
    return false;
  int reversals = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (turn(p, i) != sense)
      return false;
    if ((p[previous(p, i)] < p[i]) != (p[i] < p[next(p, i)]))
      ++reversals;
  }
  return reversals == 2;
}

bool find_repeated(const Points& p, OutlineCheck& check) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return p[a] != p[b] ? p[a] < p[b] : a < b;
  });
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (p[order[k - 1]] == p[order[k]]) {
      check = fault_at(OutlineFault::repeated_corner, order[k - 1], order[k]);
      return true;
    }
  }
  return false;
}

bool all_on_one_line(const Points& p) {
  for (std::size_t i = 2; i < p.size(); ++i) {
    if (CGAL::orientation(p[0], p[1], p[i]) != CGAL::COLLINEAR)
      return false;
  }
  return true;
}

// Tests whether sides i and j, i < j, share more than the corner that neighbours share.
bool sides_cross(const Points& p, std::size_t i, std::size_t j) {
  const std::size_t ni = next(p, i);
  const std::size_t nj = next(p, j);
  const Filtered::Segment_2 a(p[i], p[ni]);
  const Filtered::Segment_2 b(p[j], p[nj]);
  if (ni != j && nj != i)
    return CGAL::do_intersect(a, b);
  const std::size_t shared = ni == j ? j : i;
  // The sides are folded back if they are collinear and do not continue straight on.
  return turn(p, shared) == CGAL::COLLINEAR &&
         !CGAL::collinear_are_ordered_along_line(p[previous(p, shared)], p[shared],
                                                 p[next(p, shared)]);
}

// Reports the first crossing among pairs of sides whose boxes overlap, in a sweep along
// x.
bool find_crossing(const Points& p, OutlineCheck& check) {
  struct Side {
    CGAL::Bbox_2 box;
    std::size_t index;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < p.size(); ++i) {
    sides.push_back({p[i].bbox() + p[next(p, i)].bbox(), i});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.box.xmin(), a.index) < std::pair(b.box.xmin(), b.index);
  });
  for (std::size_t a = 0; a < sides.size(); ++a) {
    for (std::size_t b = a + 1; b < sides.size(); ++b) {
      if (sides[b].box.xmin() > sides[a].box.xmax())
        break;
      if (!CGAL::do_overlap(sides[a].box, sides[b].box))
        continue;
      const auto [i, j] = std::minmax(sides[a].index, sides[b].index);
      if (sides_cross(p, i, j)) {
        check = fault_at(OutlineFault::self_crossing, i, j);
        return true;
      }
    }
  }
  return false;
}

}  // namespace

OutlineCheck check_outline(const Polygon& outline) {
  if (outline.size() < 3) {
    OutlineCheck check;
    check.fault = OutlineFault::too_few_corners;
    return check;
  }
  Points p;
  p.reserve(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (!outline[i].allFinite()) {
      OutlineCheck check;
      check.fault = OutlineFault::not_finite;
      check.first = static_cast<int>(i);
      return check;
    }
    p.push_back(exact::point(outline[i]));
  }
  OutlineCheck check;
  if (strictly_convex(p)) {
    check.anticlockwise = turn(p, 0) == CGAL::LEFT_TURN;
    return check;
  }
  if (find_repeated(p, check))
    return check;
  if (all_on_one_line(p)) {
    check.fault = OutlineFault::no_area;
    return check;
  }
  const bool swept = p.size() > many_corners && CGAL::is_simple_2(p.begin(), p.end());
  if (!swept && find_crossing(p, check))
    return check;
  // In a simple outline the lexicographically smallest corner (x, then y) is convex.
  const auto corner = std::min_element(p.begin(), p.end()) - p.begin();
  const CGAL::Orientation sense = turn(p, static_cast<std::size_t>(corner));
  check.anticlockwise = sense == CGAL::LEFT_TURN;
  for (std::size_t i = 0; i < p.size() && check.convex; ++i) {
    check.convex = turn(p, i) != -sense;
  }
  return check;
}

std::string describe(const OutlineCheck& check) {
  const std::string first = std::to_string(check.first + 1);
  const std::string second = std::to_string(check.second + 1);
  switch (check.fault) {
  case OutlineFault::none:
    return check.anticlockwise ? "the corners run anticlockwise" : "no fault";
  case OutlineFault::too_few_corners:
    return "fewer than three corners";
  case OutlineFault::not_finite:
    return "corner " + first + " is not a finite number";
  case OutlineFault::repeated_corner:
    return "corners " + first + " and " + second + " are the same point";
  case OutlineFault::no_area:
    return "all corners lie on one line";
  case OutlineFault::self_crossing:
    return "sides " + first + " and " + second + " cross";
  }
  return "unknown fault";
}

Polygon reversed(const Polygon& outline) {
  Polygon result = outline;
  if (!result.empty())
    std::reverse(result.begin() + 1, result.end());
  return result;
}

Polygon place_outline(const std::vector<DecimalPoint>& corners,
                      const DecimalPoint& shift, int copy) {
  const exact::Point step = exact::rational(shift);
  const exact::Vector offset(step.x() * copy, step.y() * copy);
  Polygon result;
  result.reserve(corners.size());
  for (const DecimalPoint& corner : corners) {
    result.push_back(exact::nearest(exact::rational(corner) + offset));
  }
  return result;
}

SectionProperties section_properties(const Polygon& outline) {
  SectionProperties properties;
  double twice_area = 0.0;
  double polar = 0.0;  // 12 times the polar moment about the first corner
  Eigen::Vector3d second = Eigen::Vector3d::Zero();
  Vec2 first_moment = Vec2::Zero();
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Vec2 a = outline[i] - outline[0];
    const Vec2 b = outline[i + 1] - outline[0];
    const double triangle = cross(b, a);  // clockwise corners: positive
    twice_area += triangle;
    first_moment += triangle * (a + b);
    polar += triangle * (a.squaredNorm() + a.dot(b) + b.squaredNorm());
    const auto product = [&](int j, int k) {
      return triangle *
             (2.0 * a[j] * a[k] + 2.0 * b[j] * b[k] + a[j] * b[k] + b[j] * a[k]);
    };
    second += Eigen::Vector3d(product(0, 0), product(0, 1), product(1, 1)) / 24.0;
  }
  if (twice_area == 0.0)
    return properties;
  const Vec2 centre = first_moment / (3.0 * twice_area);
  properties.area = 0.5 * twice_area;
  properties.centroid = outline[0] + centre;
  properties.polar_moment = polar / 12.0 - properties.area * centre.squaredNorm();
  const double area = properties.area;
  properties.second_moment = second - Eigen::Vector3d(area * centre.x() * centre.x(),
                                                      area * centre.x() * centre.y(),
                                                      area * centre.y() * centre.y());
  return properties;
}

double smaller_moment(const Eigen::Vector3d& second_moment, double share) {
  const double xx = second_moment[0], xy = second_moment[1], yy = second_moment[2];
  const double mean = 0.5 * (xx + yy), spread = std::hypot(0.5 * (xx - yy), xy);
  return std::max(mean - spread, share * mean);
}

}  // namespace blocks::geometry
