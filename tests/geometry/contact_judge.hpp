// The definitions of the contact predicates on boost's rationals, which share nothing
// with the code they judge, and the walls and random corners they are tried on.
#pragma once

#include "geometry/contact_predicates.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <functional>
#include <random>

namespace blocks::geometry {

using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::cpp_bin_float_100;

/// A corner with a tangent, an edge, a second edge and the centroid of the edge's
/// block.
struct Case {
  Vec2 c, p1, p2, q1, q2, centroid, neighbour;

  void transform(const std::function<Vec2(const Vec2&)>& f) {
    for (Vec2* v : {&c, &p1, &p2, &q1, &q2, &centroid, &neighbour})
      *v = f(*v);
  }
};

/// The definitions of the header, written out on rationals.
struct Judge {
  static Rational cross(const Vec2& a0, const Vec2& a1, const Vec2& b0,
                        const Vec2& b1) {
    return (Rational(a1.x()) - Rational(a0.x())) *
               (Rational(b1.y()) - Rational(b0.y())) -
           (Rational(a1.y()) - Rational(a0.y())) *
               (Rational(b1.x()) - Rational(b0.x()));
  }
  static Rational dot(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
    return (Rational(a1.x()) - Rational(a0.x())) *
               (Rational(b1.x()) - Rational(b0.x())) +
           (Rational(a1.y()) - Rational(a0.y())) *
               (Rational(b1.y()) - Rational(b0.y()));
  }
  static int overlap_sign(const Case& k) { return cross(k.p1, k.c, k.p1, k.p2).sign(); }
  static bool near_or_inside(const Case& k) {
    return cross(k.p1, k.c, k.p1, k.p2) >=
           -Rational(contact_slack) * dot(k.p1, k.p2, k.p1, k.p2);
  }
  static bool between(const Case& k) {
    const Rational s = dot(k.p1, k.c, k.p1, k.p2);
    const Rational length2 = dot(k.p1, k.p2, k.p1, k.p2);
    const Rational slack = Rational(contact_slack) * length2;
    return s >= -slack && s <= length2 + slack;
  }
  static bool within_depth(const Case& k) {
    return cross(k.p1, k.c, k.p1, k.p2) <= cross(k.p1, k.centroid, k.p1, k.p2);
  }
  /// Twice: by sin 10 degrees to 100 digits, and by the cubic it is a root of.
  static bool faces_edge(const Case& k) {
    const Rational sine = cross(k.p1, k.p2, k.c, k.neighbour);
    const Rational q =
        dot(k.p1, k.p2, k.p1, k.p2) * dot(k.c, k.neighbour, k.c, k.neighbour);
    static const Wide sin10 = sin(boost::math::constants::pi<Wide>() / 18);
    const bool by_digits = Wide(sine) >= -sin10 * sqrt(Wide(q));
    const Rational y = q == 0 ? Rational(0) : Rational(sine * sine / q);
    const bool by_cubic = sine >= 0 || (4 * y < 1 && ((64 * y - 96) * y + 36) * y <= 1);
    EXPECT_EQ(by_digits, by_cubic) << "the judges disagree";
    return by_digits;
  }
  static int compare_depth(const Case& k) {
    const Rational p = cross(k.p1, k.c, k.p1, k.p2), q = cross(k.q1, k.c, k.q1, k.q2);
    const Rational p_squared = p * abs(p) * dot(k.q1, k.q2, k.q1, k.q2);
    const Rational q_squared = q * abs(q) * dot(k.p1, k.p2, k.p1, k.p2);
    return Rational(p_squared - q_squared).sign();
  }
};

class Random {
 public:
  double uniform(double a, double b) {
    return a + (b - a) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  int whole(int a, int b) {
    return a + static_cast<int>(engine_() % static_cast<unsigned>(b - a + 1));
  }
  Vec2 vector(double size) {
    const double x = uniform(-size, size);
    return {x, uniform(-size, size)};
  }
  Case any(double size) {
    Case k;
    k.transform([&](const Vec2&) { return vector(size); });
    return k;
  }
  /// Up to `most` doubles further, either way.
  double nudge(double x, int most) {
    const double to = whole(0, 1) ? HUGE_VAL : -HUGE_VAL;
    for (int i = whole(0, most); i > 0; --i)
      x = std::nextafter(x, to);
    return x;
  }
  Vec2 nudge(const Vec2& v, int most) {
    const double x = nudge(v.x(), most);
    return {x, nudge(v.y(), most)};
  }

 private:
  std::mt19937_64 engine_{12345};
};

/// A brick (2 x 1, corners clockwise, edge p its top, edge q its right side) of a wall
/// in half-brick bond, and a corner of the same wall: whole and half numbers.
inline Case wall(Random& random) {
  const double i = random.whole(-4, 4), j = random.whole(-3, 3);
  const Vec2 c(i + random.whole(-1, 3), j + random.whole(-1, 2));
  const Vec2 t(random.whole(0, 1) ? 2 : -2, 0), s(0, random.whole(0, 1) ? 1 : -1);
  return {c,
          {i, j + 1},
          {i + 2, j + 1},
          {i + 2, j + 1},
          {i + 2, j},
          {i + 1, j + 0.5},
          c + (random.whole(0, 1) ? t : s)};
}

}  // namespace blocks::geometry
