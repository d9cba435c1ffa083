// A judge of the contact predicates on rationals of boost, and the walls and random
// corners of the tests. The judge shares nothing with the code that it judges.
#pragma once

#include "geometry/contact_predicates.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "validation/geometry/contact_draw.hpp"

namespace blocks::geometry {

using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::cpp_bin_float_100;

using Case = validation::ContactCase;

/// The definitions of geometry/contact_predicates.hpp, written out on rationals.
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
  /// Decides twice: by sin 10 degrees to 100 digits, and by the cubic of which it is a
  /// root.
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
  static int compare_depths(const Case& k) { return compare_depths(k, k.neighbour); }
  /// Returns the sign of the depth of c below edge p minus that of d below edge q.
  static int compare_depths(const Case& k, const Vec2& d) {
    const Rational p = cross(k.p1, k.c, k.p1, k.p2), q = cross(k.q1, d, k.q1, k.q2);
    const Rational p_squared = p * abs(p) * dot(k.q1, k.q2, k.q1, k.q2);
    const Rational q_squared = q * abs(q) * dot(k.p1, k.p2, k.p1, k.p2);
    return Rational(p_squared - q_squared).sign();
  }
  static bool well_between(const Case& k) {
    const Rational s = dot(k.p1, k.c, k.p1, k.p2);
    const Rational length2 = dot(k.p1, k.p2, k.p1, k.p2);
    const Rational slack = Rational(contact_slack) * length2;
    return s >= slack && s <= length2 - slack;
  }
  /// Returns the sign of the turn from the line through the centroid and c to edge p.
  static int turn_from_centroid(const Case& k) {
    return cross(k.centroid, k.c, k.p1, k.p2).sign();
  }
  /// Returns the sign of the turn from edge p to the edge from c to its neighbour.
  static int turn_sign(const Case& k) {
    return cross(k.p1, k.p2, k.c, k.neighbour).sign();
  }
  /// Decides twice, like faces_edge: by cos 10 degrees, and by the cubic of its sine.
  static bool edges_face(const Case& k) {
    const Rational cosine = dot(k.p1, k.p2, k.c, k.neighbour);
    const Rational sine = cross(k.p1, k.p2, k.c, k.neighbour);
    const Rational q =
        dot(k.p1, k.p2, k.p1, k.p2) * dot(k.c, k.neighbour, k.c, k.neighbour);
    static const Wide cos10 = cos(boost::math::constants::pi<Wide>() / 18);
    const bool by_digits = Wide(cosine) <= -cos10 * sqrt(Wide(q));
    const Rational y = sine * sine / q;
    const bool by_cubic = cosine < 0 && 4 * y < 1 && ((64 * y - 96) * y + 36) * y <= 1;
    EXPECT_EQ(by_digits, by_cubic) << "the judges disagree";
    return by_digits;
  }
  /// Compares the sine between edges p and q with that between p and the tangent of c.
  static int compare_slopes(const Case& k) {
    const Rational q = cross(k.p1, k.p2, k.q1, k.q2);
    const Rational r = cross(k.p1, k.p2, k.c, k.neighbour);
    return Rational(q * q * dot(k.c, k.neighbour, k.c, k.neighbour) -
                    r * r * dot(k.q1, k.q2, k.q1, k.q2))
        .sign();
  }
};

/// The random draws of the robustness study, with a fixed seed.
class Random : public validation::Draw {
 public:
  Random() : Draw(0, 12345) {}
  Case any(double size) { return validation::anywhere(*this, size); }
};

/// A brick near the origin and a corner of its wall. Coordinates are whole and half
/// numbers.
inline Case wall(Random& random) { return validation::brick(random, 4, 3); }

/// Returns whole numbers p, q <= limit whose ratios approach tan 10 degrees from both
/// sides. They are the convergents of its continued fraction and the fractions between.
inline std::vector<std::pair<double, double>> fractions_near_tan10(double limit) {
  using Whole = boost::multiprecision::cpp_int;
  Wide x = tan(boost::math::constants::pi<Wide>() / 18);
  Whole p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  std::vector<std::pair<double, double>> found;
  for (;;) {
    const auto term = floor(x).convert_to<Whole>();
    for (Whole part = 1; part <= term; ++part) {
      const Whole p = part * p1 + p0, q = part * q1 + q0;
      if (q > Whole(limit))
        return found;
      found.emplace_back(p.convert_to<double>(), q.convert_to<double>());
    }
    const Whole p = term * p1 + p0, q = term * q1 + q0;
    p0 = std::exchange(p1, p);
    q0 = std::exchange(q1, q);
    x = 1 / (x - Wide(term));
  }
}

}  // namespace blocks::geometry
