#include "geometry/overlap_region.hpp"

#include <vector>

#include "geometry/exact/sides.hpp"

namespace blocks::geometry::exact {
namespace {

using Side = sides::Vector<Rational>;
using Segment = sides::Part<Rational>;

thread_local unsigned long long asked = 0;

/// A vertex of the overlap region.
struct Vertex {
  Rational x, y;
};

/// Adds the ends of the segments of the polygon's sides that lie in the other polygon.
void add_vertices(Outline polygon, Outline other, std::vector<Vertex>& vertices) {
  for (int i = 0; i < static_cast<int>(polygon.size()); ++i) {
    const Segment segment = sides::part_in<Rational>(polygon, i, other);
    if (segment.is_empty())
      continue;
    const Vec2& start = sides::start_of(polygon, i);
    const Side along(start, sides::end_of(polygon, i));
    for (const Rational& at : {segment.from, segment.to})
      vertices.push_back(
          {Rational(start.x()) + at * along.x, Rational(start.y()) + at * along.y});
  }
}

}  // namespace

bool is_far(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& d,
            const Vec2& q1, const Vec2& q2, Outline one, Outline other,
            std::span<const Vec2> joints) {
  ++asked;
  const Side e(p1, p2);
  const Rational square = dot(e, e);
  // The excess of the depth over the slack, times the length of the side.
  const Rational excess = cross(Side(p1, c), e) - Rational(contact_slack) * square;
  if (excess <= 0)
    return false;
  const Rational factor(far_factor);
  const Side f(q1, q2);
  const Rational least = factor * sides::most(cross(Side(q1, d), f), Rational(0));
  if (excess * excess * dot(f, f) <= least * least * square)
    return false;
  std::vector<Vertex> vertices;
  add_vertices(one, other, vertices);
  add_vertices(other, one, vertices);
  if (vertices.empty())
    return false;
  for (const Vec2& joint : joints)
    vertices.push_back({Rational(joint.x()), Rational(joint.y())});
  Rational diameter2(0);
  for (const Vertex& p : vertices)
    for (const Vertex& q : vertices) {
      const Rational x = q.x - p.x, y = q.y - p.y;
      diameter2 = sides::most(diameter2, x * x + y * y);
    }
  return excess * excess > factor * factor * diameter2 * square;
}

bool has_segment(Outline polygon, int side, Outline other) {
  ++asked;
  return !sides::part_in<Rational>(polygon, side, other).is_empty();
}

unsigned long long overlap_region_calls() { return asked; }

}  // namespace blocks::geometry::exact
