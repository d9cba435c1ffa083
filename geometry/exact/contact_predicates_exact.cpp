// Cold paths of the contact predicates: the same polynomials in exact arithmetic.
#include <CGAL/Mpzf.h>

#include "geometry/contact_predicates.hpp"

#ifndef CGAL_HAS_MPZF
#include <CGAL/Exact_rational.h>
#endif

namespace blocks::geometry::exact {
namespace {

#ifdef CGAL_HAS_MPZF
using Number = CGAL::Mpzf;  // m 2^k, exact under +, -, *
#else
using Number = CGAL::Exact_rational;
#endif

thread_local unsigned long long call_count = 0;

int sign(const Number& x) { return static_cast<int>(CGAL::sign(x)); }

struct Vector {
  Number x, y;
  Vector(const Vec2& from, const Vec2& to)
      : x(Number(to.x()) - Number(from.x())), y(Number(to.y()) - Number(from.y())) {}
  Number squared() const { return x * x + y * y; }
};

Number cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }

}  // namespace

unsigned long long calls() { return call_count; }

[[gnu::cold]] int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  ++call_count;
  return sign(cross(Vector(p1, c), Vector(p1, p2)));
}

[[gnu::cold]] bool near_or_inside(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  ++call_count;
  const Vector e(p1, p2);
  return sign(cross(Vector(p1, c), e) + Number(contact_slack) * e.squared()) >= 0;
}

[[gnu::cold]] bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
  ++call_count;
  const Vector e(p1, p2);
  const Number s = dot(Vector(p1, c), e), square = e.squared();
  const Number slack = Number(contact_slack) * square;
  return sign(s + slack) >= 0 && sign(square - s + slack) >= 0;
}

[[gnu::cold]] bool within_depth(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                                const Vec2& p2) {
  ++call_count;
  return sign(cross(Vector(centroid, c), Vector(p1, p2))) <= 0;
}

// t.n / |t| = D / sqrt(Q). For D < 0 the corner faces the edge if y = D^2 / Q is at most
// sin^2(10 degrees), the root of 64 y^3 - 96 y^2 + 36 y - 1, which rises on [0, 1/4].
[[gnu::cold]] bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                              const Vec2& p2) {
  ++call_count;
  const Vector e(p1, p2), t(c, neighbour);
  const Number d = cross(e, t);
  if (sign(d) >= 0)
    return true;
  const Number a = d * d, q = e.squared() * t.squared();
  if (sign(Number(4.0) * a - q) >= 0)
    return false;
  return sign(a * (a * (Number(64.0) * a - Number(96.0) * q) + Number(36.0) * q * q) -
              q * q * q) <= 0;
}

[[gnu::cold]] int compare_depth(const Vec2& c, const Vec2& p1, const Vec2& p2,
                                const Vec2& q1, const Vec2& q2) {
  ++call_count;
  const Vector p(p1, p2), q(q1, q2);
  const Number a = cross(Vector(p1, c), p), b = cross(Vector(q1, c), q);
  const int sign_a = sign(a), sign_b = sign(b);
  if (sign_a != sign_b)
    return sign_a < sign_b ? -1 : 1;
  // same side: compare the squares a^2 / |p|^2 and b^2 / |q|^2
  return sign_a * sign(a * a * q.squared() - b * b * p.squared());
}

}  // namespace blocks::geometry::exact
