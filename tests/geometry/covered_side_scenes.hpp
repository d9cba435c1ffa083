// Scenes for the covered sides of the contact rule
// (docs/contact-rule.md#covered-sides): a side, the block that enters it, neighbours.
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "contact_judge.hpp"
#include "geometry/covered_side.hpp"

namespace blocks::geometry::covering_tests {

/// A side of the polygon `own` that `other` enters near one of its ends, and the
/// neighbours that may cover it.
struct Scene {
  Polygon own, other;
  std::vector<Polygon> neighbours;
  int side = 0;
  bool at_start = true;

  template <class Map> void transform(Map&& map) {
    const auto apply = [&](Polygon& polygon) {
      for (Vec2& corner : polygon)
        corner = map(corner);
    };
    apply(own), apply(other);
    for (Polygon& neighbour : neighbours)
      apply(neighbour);
  }
  /// Whether coordinates are finite and no side has length zero, as `find_cover`
  /// requires.
  bool is_proper() const {
    const auto proper = [](const Polygon& p) {
      for (std::size_t i = 0; i < p.size(); ++i)
        if (!p[i].allFinite() || p[i] == p[(i + 1) % p.size()])
          return false;
      return p.size() >= 3;
    };
    return proper(own) && proper(other) &&
           std::all_of(neighbours.begin(), neighbours.end(), proper);
  }
};
/// Returns the corners of the convex hull, clockwise, without straight corners.
inline Polygon hull(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  };
  std::sort(points.begin(), points.end(), before);
  Polygon chain;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = chain.size();
    for (const Vec2& p : points) {
      while (chain.size() >= first + 2 &&
             geometry::cross(chain.back() - chain[chain.size() - 2],
                             p - chain.back()) >= 0)
        chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

inline Polygon box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}};
}

/// Returns a random half-integer from a to b.
inline double half(Random& random, int a, int b) {
  return 0.5 * random.whole(2 * a, 2 * b);
}

/// Bricks around the top of a brick, and a block that enters the joint between them.
/// All coordinates are half-integers. Side 0 of `own` runs from (0, 0) to (length, 0).
inline Scene bricks(Random& random) {
  Scene s;
  const double length = half(random, 1, 4), height = half(random, 1, 3);
  s.own = {{0, 0}, {length, 0}, {length, -height}, {0, -height}};
  if (random.whole(0, 3) == 0)
    s.own.insert(s.own.begin() + 1, Vec2(0.5 * length, 0));  // This corner is straight.
  s.at_start = random.coin();
  const double joint = s.at_start ? 0 : length;
  for (int n = random.whole(1, 3); n > 0; --n) {
    const double gap = random.whole(0, 2) ? 0 : half(random, -1, 3);
    const double x = half(random, -1, 3), top = gap + half(random, 1, 3);
    Polygon brick = box(x, gap, x + half(random, 1, 4), top);
    if (random.whole(0, 3) == 0)
      brick[1].x() += 0.5;  // The brick is no longer a rectangle.
    const auto first = brick.begin() + random.whole(0, 3);
    std::rotate(brick.begin(), first, brick.end());
    s.neighbours.push_back(brick);
  }
  do {
    std::vector<Vec2> points;
    for (int n = random.whole(3, 5); n > 0; --n)
      points.emplace_back(joint + half(random, -3, 3), half(random, -3, 4));
    s.other = random.whole(0, 2) ? hull(points)
                                 : box(std::min(points[0].x(), points[1].x()) - 0.5,
                                       std::min(points[0].y(), points[1].y()) - 0.5,
                                       points[0].x() + 0.5, points[0].y() + 0.5);
    if (s.other.size() >= 3 &&
        geometry::cross(s.other[1] - s.other[0], s.other[2] - s.other[1]) >= 0)
      s.other.clear();
  } while (s.other.size() < 3);
  return s;
}

/// Random polygons around a joint. Each condition of the rule holds in some of them and
/// fails in others.
inline Scene random_scene(Random& random) {
  Scene s;
  const double length = random.uniform(0.5, 4);
  s.own = {{0, 0}, {length, 0}, {random.uniform(0, length), -random.uniform(0.5, 3)}};
  s.at_start = random.coin();
  const double joint = s.at_start ? 0 : length;
  for (int n = random.whole(1, 3); n > 0; --n) {
    const double gap = random.uniform(-0.3, 0.6);
    const double x0 = random.uniform(-1, 2), x1 = x0 + random.uniform(0.5, 4);
    const double slope = random.uniform(-0.25, 0.25);
    s.neighbours.push_back(
        hull({{x0, gap},
              {x1, gap + slope * (x1 - x0)},
              {random.uniform(x0, x1), gap + random.uniform(1, 3)}}));
  }
  do {
    std::vector<Vec2> points;
    for (int n = random.whole(3, 6); n > 0; --n)
      points.push_back(Vec2(joint, 0.5) + random.vector(2.5));
    s.other = hull(points);
  } while (s.other.size() < 3);
  return s;
}

inline void turn(Scene& s, double cosine, double sine, const Vec2& shift) {
  s.transform([&](const Vec2& v) -> Vec2 {
    return shift + Vec2(cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y());
  });
}

/// Returns the mirror image. Corners are listed in reverse order, so that the polygons
/// stay clockwise.
inline Scene mirrored(Scene s) {
  s.transform([](const Vec2& v) -> Vec2 { return {-v.x(), v.y()}; });
  const auto size = static_cast<int>(s.own.size());
  s.side = (2 * size - 2 - s.side) % size;
  s.at_start = !s.at_start;
  std::reverse(s.own.begin(), s.own.end());
  std::reverse(s.other.begin(), s.other.end());
  for (Polygon& neighbour : s.neighbours)
    std::reverse(neighbour.begin(), neighbour.end());
  return s;
}

inline Cover covering_of(const Scene& s) {
  const std::vector<Outline> neighbours(s.neighbours.begin(), s.neighbours.end());
  return find_cover({s.own, s.side, s.at_start}, s.other, neighbours);
}

inline std::string text(const Scene& s) {
  std::ostringstream out;
  out << std::hexfloat << "side " << s.side << " at start " << s.at_start;
  const auto print = [&](const char* name, const Polygon& polygon) {
    out << "\n" << name;
    for (const Vec2& corner : polygon)
      out << " (" << corner.x() << ", " << corner.y() << ")";
  };
  print("own", s.own), print("other", s.other);
  for (const Polygon& neighbour : s.neighbours)
    print("neighbour", neighbour);
  return out.str();
}

}  // namespace blocks::geometry::covering_tests
