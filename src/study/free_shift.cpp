#include "study/free_shift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/convex_parts.hpp"

namespace blocks::study {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The outward unit normal of side i of a clockwise outline.
Vec2 outward(const Polygon& outline, std::size_t i) {
  const Vec2 along = outline[(i + 1) % outline.size()] - outline[i];
  return Vec2(-along.y(), along.x()).normalized();
}

std::pair<double, double> extent(const Polygon& outline, const Vec2& axis) {
  std::pair<double, double> range(infinite, -infinite);
  for (const Vec2& p : outline) {
    const double at = axis.dot(p);
    range = {std::min(range.first, at), std::max(range.second, at)};
  }
  return range;
}

/// The open interval of t for which block + t direction intersects a convex part. It is
/// empty if its end is not above its begin.
std::pair<double, double> hits(const Polygon& block, const Polygon& part,
                               const Vec2& direction) {
  double begin = -infinite, end = infinite;
  for (const Polygon* polygon : {&block, &part})
    for (std::size_t i = 0; i < polygon->size(); ++i) {
      const Vec2 axis = outward(*polygon, i);
      const auto [b0, b1] = extent(block, axis);
      const auto [p0, p1] = extent(part, axis);
      const double rate = axis.dot(direction);
      if (std::abs(rate) < 1e-12) {
        if (b0 >= p1 || b1 <= p0)
          return {0.0, 0.0};
        continue;
      }
      double first = (p0 - b1) / rate, last = (p1 - b0) / rate;
      if (first > last)
        std::swap(first, last);
      begin = std::max(begin, first), end = std::min(end, last);
    }
  return {begin, end};
}

/// The distance of a point from the border of an outline if the point is inside;
/// otherwise 0.
double depth_of(const Vec2& point, const Polygon& outline) {
  bool inside = false;
  double square = infinite;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()], along = b - a;
    const double t = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    square = std::min(square, (point - a - t * along).squaredNorm());
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (point.y() - a.y()) / along.y() * along.x())
      inside = !inside;
  }
  return inside ? std::sqrt(square) : 0.0;
}

}  // namespace

Domain make_domain(const Polygon& outline) {
  Domain domain{outline, {}};
  for (const std::vector<int>& corners : geometry::convex_parts(outline)) {
    Polygon& part = domain.parts.emplace_back();
    for (const int corner : corners)
      part.push_back(outline[static_cast<std::size_t>(corner)]);
  }
  return domain;
}

double free_shift(const Polygon& block, const Domain& domain, const Vec2& direction) {
  std::vector<std::pair<double, double>> blocked;
  for (const Polygon& part : domain.parts) {
    const auto interval = hits(block, part, direction);
    if (interval.second > std::max(0.0, interval.first))
      blocked.push_back(interval);
  }
  std::sort(blocked.begin(), blocked.end());
  double shift = 0.0;
  for (const auto& [begin, end] : blocked)
    if (begin <= shift)
      shift = std::max(shift, end);
  return shift;
}

double min_shift(const Polygon& block, const Domain& domain) {
  constexpr int points = 8;  // of a side of the block
  double deepest = 0.0;
  for (std::size_t i = 0; i < block.size(); ++i)
    for (int k = 0; k < points; ++k) {
      const double t = static_cast<double>(k) / points;
      const Vec2 point = (1.0 - t) * block[i] + t * block[(i + 1) % block.size()];
      deepest = std::max(deepest, depth_of(point, domain.outline));
    }
  for (const Vec2& corner : domain.outline)
    deepest = std::max(deepest, depth_of(corner, block));
  return deepest;
}

double max_shift(const Polygon& block, const Domain& domain) {
  double min = infinite;
  const auto attempt = [&](const Vec2& direction) {
    if (direction.squaredNorm() > 0.0)
      min = std::min(min, free_shift(block, domain, direction.normalized()));
  };
  for (std::size_t i = 0; i < block.size(); ++i)
    attempt(-outward(block, i));
  const std::size_t n = domain.outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 normal = outward(domain.outline, i);
    attempt(normal);
    attempt(normal + outward(domain.outline, (i + n - 1) % n));
  }
  return min;
}

}  // namespace blocks::study
