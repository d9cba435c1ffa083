#include "validation/geometry/naive_layer.hpp"

#include <cmath>
#include <numbers>

namespace blocks::validation {
namespace {

using geometry::LayerRequest;
using geometry::Mesh;
using geometry::Spacing;
using geometry::Vec2;

struct Corners {
  Vec2 bl, tl, tr, br;
};

// The bottom and top end of one side.
struct Ends {
  Vec2 bottom, top;
};

double uniform(const LayerRequest& request, std::size_t block, std::uint32_t draw,
               std::uint32_t use) {
  return std::ldexp(
      static_cast<double>(geometry::random_53_bits(request.stream, block, draw, use)),
      -53);
}

std::vector<double> listed_places(const std::vector<geometry::Decimal>& widths) {
  std::vector<double> places = {0.0};
  for (const auto& width : widths)
    places.push_back(places.back() + width.value());
  for (double& s : places)
    s /= places.back() == 0.0 ? 1.0 : places.back();
  return places;
}

// Applies the law of the random widths in doubles, then MERGE. `numbers` receives the
// number of the block that ends at each place.
std::vector<double> random_places(const LayerRequest& request, double length,
                                  double height, std::vector<std::size_t>& numbers) {
  const double low = 0.2 * height;
  const double high = 3.0 * height;
  const auto n = static_cast<std::size_t>(request.count);
  std::vector<double> widths;
  double sum = 0.0;
  for (std::size_t block = 1; block <= n; ++block) {
    widths.push_back(low + (high - low) * uniform(request, block, 0, 0));
    sum += widths.back();
  }
  const double min = static_cast<double>(n) * low;
  const double max = static_cast<double>(n) * high;
  for (double& w : widths) {
    w = sum > length ? low + (w - low) * (length - min) / (sum - min)
                     : high - (high - w) * (max - length) / (max - sum);
  }
  std::vector<double> places = {0.0};
  numbers = {0};
  double at = 0.0;
  double kept = 0.0;
  const double smallest =
      request.merge_ratio ? request.merge_ratio->value() * height : 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    at += widths[i];
    if (at - kept < smallest && i + 1 < n)
      continue;
    if (at - kept < smallest && places.size() > 1) {
      places.pop_back();
      numbers.pop_back();
    }
    places.push_back(i + 1 < n ? at / length : 1.0);
    numbers.push_back(i + 1);
    kept = at;
  }
  return places;
}

// Returns the intersection of the line through p along u with the line q + f v.
Vec2 intersection(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v) {
  return q + v * (geometry::cross(p - q, u) / geometry::cross(v, u));
}

bool right_of(const Ends& side, const Ends& left, const Vec2& bottom, const Vec2& top) {
  return (side.bottom - left.bottom).dot(bottom) > 0.0 &&
         (side.top - left.top).dot(top) > 0.0;
}

std::vector<Ends> random_sides(const LayerRequest& request, const Corners& c,
                               Crossings crossings) {
  const Vec2 bottom = c.br - c.bl;
  const Vec2 top = c.tr - c.tl;
  const Vec2 start = (c.bl + c.tl) / 2.0;
  const Vec2 mid = (bottom + top) / 2.0;
  const double area = std::abs(geometry::cross(c.tr - c.bl, c.br - c.tl)) /
                      2.0;  // for either orientation
  const double length = mid.norm();
  std::vector<std::size_t> numbers;
  const auto places = random_places(request, length, area / length, numbers);

  std::vector<Ends> sides = {{c.bl, c.tl}};
  const Ends last = {c.br, c.tr};
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const Vec2 here = start + mid * places[i];
    const auto drawn = [&](std::uint32_t draw) {
      const double low = request.angle_min.value();
      const double angle = (low + (request.angle_max.value() - low) *
                                      uniform(request, numbers[i], draw, 1)) *
                           std::numbers::pi / 180.0;
      const Vec2 direction =
          Vec2(-mid.y(), mid.x()) * std::cos(angle) - mid * std::sin(angle);
      return Ends{intersection(here, direction, c.bl, bottom),
                  intersection(here, direction, c.tl, top)};
    };
    Ends side = drawn(0);
    if (crossings == Crossings::checked) {
      const auto fits = [&] {
        return right_of(side, sides.back(), bottom, top) &&
               right_of(last, side, bottom, top);
      };
      for (std::uint32_t draw = 1; draw <= 16 && !fits(); ++draw)
        side = drawn(draw);
      if (!fits()) {
        // The side joins equal fractions between the last side and the far end.
        const double s = (places[i] - places[i - 1]) / (1.0 - places[i - 1]);
        side = {sides.back().bottom + (last.bottom - sides.back().bottom) * s,
                sides.back().top + (last.top - sides.back().top) * s};
      }
    }
    sides.push_back(side);
  }
  sides.push_back(last);
  return sides;
}

std::vector<Ends> divided_sides(const LayerRequest& request, const Corners& c) {
  std::vector<double> bottom;
  std::vector<double> top;
  if (request.spacing == Spacing::listed) {
    bottom = listed_places(request.bottom);
    top = listed_places(request.top);
  } else {
    for (int i = 0; i <= request.count; ++i)
      bottom.push_back(static_cast<double>(i) / request.count);
    top = bottom;
  }
  std::vector<Ends> sides;
  for (std::size_t i = 0; i < bottom.size(); ++i)
    sides.push_back({c.bl + (c.br - c.bl) * bottom[i], c.tl + (c.tr - c.tl) * top[i]});
  return sides;
}

}  // namespace

Mesh naive_layer(const LayerRequest& request, Crossings crossings) {
  const auto corner = [&request](std::size_t i) {
    return Vec2(request.corners[i].x.value(), request.corners[i].y.value());
  };
  const Corners c = {corner(0), corner(1), corner(2), corner(3)};
  const auto sides = request.spacing == Spacing::random
                         ? random_sides(request, c, crossings)
                         : divided_sides(request, c);
  Mesh mesh;
  const int n = static_cast<int>(sides.size());
  for (const Ends& side : sides)
    mesh.vertices.push_back(side.bottom);
  for (const Ends& side : sides)
    mesh.vertices.push_back(side.top);
  for (int i = 0; i + 1 < n; ++i)
    mesh.cells.push_back({i, n + i, n + i + 1, i + 1});
  mesh.outline.push_back(0);
  for (int i = 0; i < n; ++i)
    mesh.outline.push_back(n + i);
  for (int i = n - 1; i > 0; --i)
    mesh.outline.push_back(i);
  return mesh;
}

}  // namespace blocks::validation
