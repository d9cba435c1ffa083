#include "geometry/exact/line.hpp"

#include <gmp.h>

#include <algorithm>
#include <cmath>

namespace blocks::geometry::exact {
namespace {

// Scales two integers by one power of two, so that the larger one is between 1/2 and 1.
void scaled(const Integer& a, const Integer& b, double& x, double& y) {
  long i = 0, j = 0;
  x = mpz_get_d_2exp(&i, a.mpz());
  y = mpz_get_d_2exp(&j, b.mpz());
  const long top = x == 0.0 ? j : y == 0.0 ? i : std::max(i, j);
  x = std::ldexp(x, static_cast<int>(std::max(i - top, -2000L)));
  y = std::ldexp(y, static_cast<int>(std::max(j - top, -2000L)));
}

}  // namespace

Line::Line(const Point& p, const Point& q) {
  const Integer u = common_denominator({p.x(), p.y()}),
                v = common_denominator({q.x(), q.y()});
  const Integer px = times(p.x(), u), py = times(p.y(), u);
  const Integer qx = times(q.x(), v), qy = times(q.y(), v);
  a = py * v - qy * u;
  b = qx * u - px * v;
  c = px * qy - qx * py;
  Integer common;
  mpz_gcd(common.mpz(), a.mpz(), b.mpz());
  mpz_gcd(common.mpz(), common.mpz(), c.mpz());
  if (common > 1)
    for (Integer* value : {&a, &b, &c})
      mpz_divexact(value->mpz(), value->mpz(), common.mpz());
  scaled(b, a, run, rise);
  run = -run;
}

bool parallel(const Line& s, const Line& t) {
  // The components are at most 1 and have an error of 2^-52 or less, so the two
  // products are certain to 2^-49.
  if (std::abs(s.run * t.rise - s.rise * t.run) > 0x1p-49)
    return false;
  return s.a * t.b == s.b * t.a;
}

bool on(const Line& line, const Point& p) {
  return Rational(line.a) * p.x() + Rational(line.b) * p.y() + Rational(line.c) == 0;
}

Place intersection(const Line& s, const Line& t) {
  Place place{s.b * t.c - s.c * t.b, s.c * t.a - s.a * t.c, s.a * t.b - s.b * t.a};
  if (place.w < 0) {
    place.x = -place.x;
    place.y = -place.y;
    place.w = -place.w;
  }
  return place;
}

}  // namespace blocks::geometry::exact
