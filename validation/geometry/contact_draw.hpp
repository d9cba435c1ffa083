// Random corners, edges and bricks for the contact predicates, shared by the study and
// the tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/vec2.hpp"

namespace blocks::validation {

using geometry::Vec2;

/// A corner with a tangent, an edge, a second edge and the centroid of the edge's
/// block. Coordinates are finite, p1 and p2 differ, and so do q1 and q2.
struct ContactCase {
  Vec2 c, p1, p2, q1, q2, centroid, neighbour;

  template <class Map> void transform(Map&& map) {
    for (Vec2* v : {&c, &p1, &p2, &q1, &q2, &centroid, &neighbour})
      *v = map(*v);
  }
  /// Are all coordinates finite and both edges longer than zero, as predicates require?
  bool proper() const {
    bool finite = true;
    for (const Vec2* v : {&c, &p1, &p2, &q1, &q2, &centroid, &neighbour})
      finite = finite && v->allFinite();
    return finite && p1 != p2 && q1 != q2;
  }
};

/// Random numbers by Splitmix64, seeded by the family and number of the case.
class Draw {
 public:
  Draw(std::uint64_t family, std::uint64_t number)
      : state_(number * 0x9e3779b97f4a7c15ULL + (family << 56)) {}
  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  double uniform(double a, double b) {
    return a + (b - a) * std::ldexp(static_cast<double>(bits() >> 11), -53);
  }
  int whole(int a, int b) {
    return a + static_cast<int>(bits() % static_cast<unsigned>(b - a + 1));
  }
  bool coin() { return bits() % 2 == 0; }
  Vec2 vector(double size) {
    const double x = uniform(-size, size);
    return {x, uniform(-size, size)};
  }
  /// Moves x by up to `max` doubles in a random direction.
  double nudge(double x, int max) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double to = coin() ? infinity : -infinity;
    for (int i = whole(0, max); i > 0; --i)
      x = std::nextafter(x, to);
    return x;
  }
  Vec2 nudge(const Vec2& v, int max) {
    const double x = nudge(v.x(), max);
    return {x, nudge(v.y(), max)};
  }

 private:
  std::uint64_t state_;
};

/// Makes a case of random points with coordinates up to `size`.
inline ContactCase anywhere(Draw& draw, double size) {
  ContactCase k;
  k.transform([&](const Vec2&) { return draw.vector(size); });
  return k;
}

/// Makes a case from a wall in half-brick bond: a brick of 2 x 1 (edge p is its top,
/// edge q its right side) and a corner of the same wall. The wall extends by `columns`
/// and `rows` to either side of the origin.
inline ContactCase brick(Draw& draw, int columns = 20, int rows = 20) {
  const double i = draw.whole(-columns, columns), j = draw.whole(-rows, rows);
  const Vec2 c(i + draw.whole(-1, 3), j + draw.whole(-1, 2));
  const Vec2 along(draw.coin() ? 2 : -2, 0), across(0, draw.coin() ? 1 : -1);
  return {c,
          {i, j + 1},
          {i + 2, j + 1},
          {i + 2, j + 1},
          {i + 2, j},
          {i + 1, j + 0.5},
          c + (draw.coin() ? along : across)};
}

}  // namespace blocks::validation
