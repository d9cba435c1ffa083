#include "validation/geometry/split_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/polygon.hpp"
#include "validation/geometry/contact_draw.hpp"

namespace blocks::validation {
namespace {

using geometry::cross;
using geometry::Polygon;
using geometry::SplitLine;

enum Kind : std::size_t {
  anywhere_,
  through_corner,
  through_corners,
  along_side,
  beside_corner,
  beside_side,
  far_away
};
constexpr std::array<SplitFamily, 7> family_list = {{
    {"random lines", 30},
    {"through a corner", 14},
    {"through two corners", 14},
    {"along a side", 12},
    {"1e-12 beside a corner", 12},
    {"1e-12 beside a side", 12},
    {"through a point far away", 6},
}};

constexpr double beside = 1e-12;  // of the size of the outline

// Rounded square roots and divisions only, so that all machines agree.
Vec2 direction(Draw& draw) {
  for (;;) {
    const Vec2 v = draw.vector(1.0);
    const double length = std::sqrt(v.x() * v.x() + v.y() * v.y());
    if (length > 0.1 && length < 1.0)
      return v / length;
  }
}

bool half_plane(const Vec2& v) { return v.y() > 0.0 || (v.y() == 0.0 && v.x() > 0.0); }

// Returns n distinct directions, clockwise.
std::vector<Vec2> fan(Draw& draw, int n) {
  std::vector<Vec2> rays;
  for (int i = 0; i < n; ++i)
    rays.push_back(direction(draw));
  std::sort(rays.begin(), rays.end(), [](const Vec2& a, const Vec2& b) {
    return half_plane(a) != half_plane(b) ? half_plane(a) : cross(a, b) < 0.0;
  });
  return rays;
}

Polygon convex(Draw& draw) { return fan(draw, draw.whole(3, 12)); }

// Radii between `min` and 1.
Polygon star(Draw& draw, double min) {
  Polygon outline = fan(draw, draw.whole(4, 20));
  for (Vec2& corner : outline)
    corner *= draw.uniform(min, 1.0);
  return outline;
}

// A rectangle of half numbers, with up to three straight corners on each side.
Polygon rectangle(Draw& draw) {
  const double x = draw.whole(-4, 4), y = draw.whole(-4, 4);
  const double w = draw.whole(1, 4), h = draw.whole(1, 2);
  const std::array<Vec2, 4> corners = {Vec2(x, y), Vec2(x, y + h), Vec2(x + w, y + h),
                                       Vec2(x + w, y)};
  Polygon outline;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % 4];
    outline.push_back(a);
    for (int k = 1; k < 4; ++k)
      if (draw.whole(0, 5) == 0)
        outline.push_back(a + 0.25 * k * (b - a));
  }
  return outline;
}

// Teeth of whole heights on a base, with runs of collinear sides at several heights.
Polygon comb(Draw& draw) {
  const int teeth = draw.whole(1, 6);
  Polygon outline = {Vec2(0, 0)};
  for (int i = 0; i < teeth; ++i) {
    const double height = draw.whole(1, 3);
    outline.emplace_back(i, height);
    outline.emplace_back(i + 1, height);
  }
  outline.emplace_back(teeth, 0);
  for (int i = teeth - 1; i > 0; --i)
    if (draw.coin())
      outline.emplace_back(i, 0);
  if (draw.coin())  // slanted teeth
    for (Vec2& corner : outline)
      corner.x() += corner.y() * (corner.y() > 1.0 ? 0.75 : 0.25);
  Polygon distinct;
  for (const Vec2& corner : outline)
    if (distinct.empty() || corner != distinct.back())
      distinct.push_back(corner);
  return distinct;
}

Polygon shape(Draw& draw) {
  switch (draw.whole(0, 9)) {
  case 0:
  case 1:
    return convex(draw);
  case 2:
  case 3: {
    const auto corners = fan(draw, 4);
    return {corners.begin(), corners.end()};
  }
  case 4:
    return rectangle(draw);
  case 5:
  case 6:
    return star(draw, 0.3);
  case 7:
    return star(draw, 0.02);
  default:
    return comb(draw);
  }
}

// Turns, flattens, moves or scales an outline, or leaves it as it is.
void transform(Draw& draw, Polygon& outline) {
  const int kind = draw.whole(0, 9);
  if (kind < 3)
    return;
  const Vec2 axis = direction(draw);
  const double flat = kind == 5 ? std::ldexp(1.0, -draw.whole(10, 45)) : 1.0;
  const double scale = kind == 6 ? 1e-9
                       : kind == 7
                           ? std::ldexp(draw.uniform(1, 2), draw.whole(-300, 300))
                           : 1.0;
  const Vec2 shift = kind >= 8
                         ? Vec2(draw.uniform(-1, 1) * 1e8, draw.uniform(-1, 1) * 1e8)
                         : Vec2(0, 0);
  const bool turned = kind != 8;
  for (Vec2& v : outline) {
    v.y() *= flat;
    if (turned)
      v = Vec2(axis.x() * v.x() - axis.y() * v.y(),
               axis.y() * v.x() + axis.x() * v.y());
    v = scale * v + shift;
  }
}

Polygon outline_of(Draw& draw) {
  for (;;) {
    Polygon outline = shape(draw);
    transform(draw, outline);
    const auto check = geometry::check_outline(outline);
    if (check.fault != geometry::OutlineFault::none || check.anticlockwise)
      continue;
    const auto shift = draw.whole(0, static_cast<int>(outline.size()) - 1);
    std::rotate(outline.begin(), outline.begin() + shift, outline.end());
    return outline;
  }
}

}  // namespace

std::span<const SplitFamily> split_families() { return family_list; }

SplitCase make_split_case(std::size_t family, std::uint64_t number) {
  Draw draw(family + 1, number);
  SplitCase result;
  Polygon& outline = result.outline;
  outline = outline_of(draw);
  const int n = static_cast<int>(outline.size());
  Vec2 low = outline[0], high = outline[0];
  for (const Vec2& v : outline) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const double size = (high - low).maxCoeff();
  const auto properties = geometry::section_properties(outline);
  const int i = draw.whole(0, n - 1), j = (i + draw.whole(1, n - 1)) % n;
  const auto corner = [&](int k) { return outline[static_cast<std::size_t>(k % n)]; };
  SplitLine& line = result.line;
  line.along = direction(draw) * (draw.coin() ? 1.0 : size);
  line.point = draw.coin() ? properties.centroid
                           : Vec2(draw.uniform(low.x(), high.x()),
                                  draw.uniform(low.y(), high.y()));
  switch (family) {
  case through_corner:
    line.point = corner(i);
    break;
  case through_corners:
    line.point = corner(i);
    line.along = corner(j) - corner(i);
    break;
  case along_side:
    line.point = corner(i);
    line.along = corner(i + 1) - corner(i);
    break;
  case beside_corner:
    line.point = corner(i) + beside * size * direction(draw);
    if (draw.coin())
      line.along = corner(j) - corner(i);
    break;
  case beside_side: {
    const Vec2 side = corner(i + 1) - corner(i);
    const double longest = side.cwiseAbs().maxCoeff();
    const Vec2 unit = side / longest;
    line.point = corner(i) + draw.uniform(-1, 2) * side +
                 (draw.coin() ? beside : -beside) * size * Vec2(-unit.y(), unit.x());
    line.along = side;
    break;
  }
  case far_away:
    line.along = corner(j) - corner(i);
    line.point = corner(i) + draw.uniform(-1e3, 1e3) * line.along;
    break;
  default:
    break;
  }
  if (draw.coin())
    line.along = -line.along;
  constexpr std::array<double, 4> min = {0.0, 1e-3, 0.1, 0.4};
  result.min_area = min[static_cast<std::size_t>(draw.whole(0, 3))] * properties.area;
  switch (draw.whole(0, 3)) {
  case 0:
    line.near = 0.0;
    break;
  case 1:
    line.near = 0.1 * size;
    break;
  default:
    line.near = 0.05 * std::sqrt(result.min_area);
    break;
  }
  return result;
}

}  // namespace blocks::validation
