// The definitions of the contact predicates on boost's rationals, which share nothing
// with the code they judge, and the walls and random corners they are tried on.
#pragma once

#include "geometry/contact_predicates.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "validation/robustness/contact_draw.hpp"

namespace blocks::geometry {

using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::cpp_bin_float_100;

using Case = robustness::ContactCase;

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

/// The study's draws, one after the other.
class Random : public robustness::Draw {
 public:
  Random() : Draw(0, 12345) {}
  Case any(double size) { return robustness::anywhere(*this, size); }
};

/// A brick near the origin and a corner of its wall: whole and half numbers.
inline Case wall(Random& random) { return robustness::brick(random, 4, 3); }

}  // namespace blocks::geometry
