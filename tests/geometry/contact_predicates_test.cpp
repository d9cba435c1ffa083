// The contact predicates against an independent oracle (boost rationals): 0 wrong.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "geometry/contact_predicates.hpp"

namespace blocks::geometry {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::cpp_bin_float_100;

/// Oracle: the definitions of rules 9-12, written out on rationals.
struct Oracle {
  static Rational cross(const Vec2& o, const Vec2& a, const Vec2& p, const Vec2& q) {
    return (Rational(a.x()) - Rational(o.x())) * (Rational(q.y()) - Rational(p.y())) -
           (Rational(a.y()) - Rational(o.y())) * (Rational(q.x()) - Rational(p.x()));
  }
  static Rational dot(const Vec2& o, const Vec2& a, const Vec2& p, const Vec2& q) {
    return (Rational(a.x()) - Rational(o.x())) * (Rational(q.x()) - Rational(p.x())) +
           (Rational(a.y()) - Rational(o.y())) * (Rational(q.y()) - Rational(p.y()));
  }
  static int overlap_sign(const Vec2& c, const Vec2& p, const Vec2& q) {
    return cross(p, c, p, q).sign();
  }
  static bool near_or_inside(const Vec2& c, const Vec2& p, const Vec2& q) {
    return cross(p, c, p, q) >= -Rational(contact_slack) * dot(p, q, p, q);
  }
  static bool between(const Vec2& c, const Vec2& p, const Vec2& q) {
    const Rational s = dot(p, c, p, q), l = dot(p, q, p, q), eps(contact_slack);
    return s >= -eps * l && s <= (1 + eps) * l;
  }
  static bool within_depth(const Vec2& c, const Vec2& g, const Vec2& p, const Vec2& q) {
    return cross(p, c, p, q) <= cross(p, g, p, q);
  }
  /// sin 10 degrees to 100 digits by its own definition, not by the cubic.
  static bool faces_edge(const Vec2& c, const Vec2& n, const Vec2& p, const Vec2& q) {
    static const Wide sine = sin(boost::math::constants::pi<Wide>() / 18);
    const Wide d(-cross(c, n, p, q));
    const Wide l = sqrt(Wide(dot(p, q, p, q))) * sqrt(Wide(dot(c, n, c, n)));
    return d >= -sine * l;
  }
  static int compare_depth(const Vec2& c, const Vec2& p1, const Vec2& p2, const Vec2& q1,
                           const Vec2& q2) {
    const Rational a = cross(p1, c, p1, p2), b = cross(q1, c, q1, q2);
    const Rational left = a * abs(a) * dot(q1, q2, q1, q2);
    const Rational right = b * abs(b) * dot(p1, p2, p1, p2);
    return left < right ? -1 : left > right ? 1 : 0;
  }
};

/// A corner, an edge, a second edge and a centroid, ordinary or as nasty as bricks get.
struct Case {
  Vec2 c, p1, p2, q1, q2, centroid, neighbour;
};

void expect_all_agree(const Case& k) {
  ASSERT_EQ(overlap_sign(k.c, k.p1, k.p2), Oracle::overlap_sign(k.c, k.p1, k.p2));
  ASSERT_EQ(near_or_inside(k.c, k.p1, k.p2), Oracle::near_or_inside(k.c, k.p1, k.p2));
  ASSERT_EQ(between(k.c, k.p1, k.p2), Oracle::between(k.c, k.p1, k.p2));
  ASSERT_EQ(within_depth(k.c, k.centroid, k.p1, k.p2),
            Oracle::within_depth(k.c, k.centroid, k.p1, k.p2));
  ASSERT_EQ(in_reach_of_edge(k.c, k.centroid, k.p1, k.p2),
            near_or_inside(k.c, k.p1, k.p2) && between(k.c, k.p1, k.p2) &&
                within_depth(k.c, k.centroid, k.p1, k.p2));
  ASSERT_EQ(faces_edge(k.c, k.neighbour, k.p1, k.p2),
            Oracle::faces_edge(k.c, k.neighbour, k.p1, k.p2));
  ASSERT_EQ(compare_depth(k.c, k.p1, k.p2, k.q1, k.q2),
            Oracle::compare_depth(k.c, k.p1, k.p2, k.q1, k.q2));
}

class Random {
 public:
  double uniform(double a, double b) {
    return a + (b - a) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  int whole(int a, int b) { return a + static_cast<int>(engine_() % static_cast<unsigned>(b - a + 1)); }

 private:
  std::mt19937_64 engine_{12345};
};

/// Bricks on a grid, turned and shifted: most corners lie on edges but for rounding.
Case brick_case(Random& random, double offset) {
  const double angle = random.uniform(0, 6.3), cx = std::cos(angle), sx = std::sin(angle);
  const Vec2 origin(random.uniform(-1, 1) * offset, random.uniform(-1, 1) * offset);
  const auto place = [&](double x, double y) -> Vec2 {
    return {origin.x() + cx * x - sx * y, origin.y() + sx * x + cx * y};
  };
  const double i = random.whole(-2, 2), j = random.whole(-2, 2);
  return {place(0.5 * random.whole(-4, 4), 0.5 * random.whole(-4, 4)),
          place(i, j), place(i + 1, j), place(i + 1, j), place(i + 1, j - 0.5),
          place(i + 0.5, j - 0.25),
          place(0.5 * random.whole(-4, 4) + 0.1, 0.5 * random.whole(-4, 4))};
}

TEST(ContactPredicates, AgreeWithTheOracleOnTurnedBricks) {
  Random random;
  for (const double offset : {0.0, 1.0, 1e3, 1e6, 1e9, 1e15})
    for (int i = 0; i < 2500; ++i)
      ASSERT_NO_FATAL_FAILURE(expect_all_agree(brick_case(random, offset)))
          << "offset " << offset << " case " << i;
}

// 3-4-5 rotations of whole coordinates are exact: truly collinear, truly on the limits.
TEST(ContactPredicates, DecideExactTiesOfPythagoreanBricks) {
  Random random;
  const auto place = [](int x, int y) { return Vec2(3.0 * x - 4.0 * y, 4.0 * x + 3.0 * y); };
  for (int n = 0; n < 4000; ++n) {
    const auto any = [&] { return place(random.whole(-3, 3), random.whole(-3, 3)); };
    const int i = random.whole(-2, 2), j = random.whole(-2, 2);
    Case k{any(), place(i, j), place(i + 2, j), place(i + 2, j), place(i + 2, j - 2),
           place(i + 1, j - 1), any()};
    if (k.neighbour == k.c)
      k.neighbour += Vec2(1, 0);
    ASSERT_NO_FATAL_FAILURE(expect_all_agree(k)) << n;
  }
}

// Tangents within one rounding of -10 degrees, where only the cubic can tell.
TEST(ContactPredicates, DecideTangentsNextToMinusTenDegrees) {
  Random random;
  int facing = 0;
  for (int n = 0; n < 4000; ++n) {
    const double length = std::ldexp(random.uniform(0.5, 1), random.whole(-30, 30));
    Vec2 t(length * std::cos(M_PI / 18), -length * std::sin(M_PI / 18));
    for (int ulps = random.whole(0, 3); ulps > 0; --ulps)
      t.y() = std::nextafter(t.y(), random.whole(0, 1) ? 0.0 : -1e9);
    const Vec2 p1(0, 0), p2(random.uniform(0.1, 10), 0), c(0, 0);
    const bool ours = faces_edge(c, t, p1, p2);
    ASSERT_EQ(ours, Oracle::faces_edge(c, t, p1, p2)) << n;
    facing += ours;
  }
  EXPECT_GT(facing, 400);
  EXPECT_LT(facing, 3600);
}

// Magnitudes from subnormal to near overflow go through the exact path unharmed.
TEST(ContactPredicates, SurviveExtremeMagnitudes) {
  Random random;
  for (int n = 0; n < 1500; ++n) {
    const double scale = std::ldexp(1.0, random.whole(-1060, 500));
    const auto any = [&] { return Vec2(scale * random.uniform(-1, 1), scale * random.uniform(-1, 1)); };
    const Case k{any(), any(), any(), any(), any(), any(), any()};
    ASSERT_EQ(overlap_sign(k.c, k.p1, k.p2), Oracle::overlap_sign(k.c, k.p1, k.p2)) << n;
    ASSERT_EQ(between(k.c, k.p1, k.p2), Oracle::between(k.c, k.p1, k.p2)) << n;
    ASSERT_EQ(near_or_inside(k.c, k.p1, k.p2), Oracle::near_or_inside(k.c, k.p1, k.p2)) << n;
    ASSERT_EQ(compare_depth(k.c, k.p1, k.p2, k.q1, k.q2),
              Oracle::compare_depth(k.c, k.p1, k.p2, k.q1, k.q2)) << n;
  }
}

// The laws of the header.
TEST(ContactPredicates, ObeyTheirLaws) {
  Random random;
  for (int n = 0; n < 20000; ++n) {
    const Case k = brick_case(random, n % 2 ? 1e6 : 1.0);
    const int sign = overlap_sign(k.c, k.p1, k.p2);
    ASSERT_EQ(sign, -overlap_sign(k.c, k.p2, k.p1));
    ASSERT_EQ(sign, overlap_sign(k.p1, k.p2, k.c));
    ASSERT_EQ(between(k.c, k.p1, k.p2), between(k.c, k.p2, k.p1));
    ASSERT_EQ(compare_depth(k.c, k.p1, k.p2, k.q1, k.q2),
              -compare_depth(k.c, k.q1, k.q2, k.p1, k.p2));
    ASSERT_EQ(compare_depth(k.c, k.p1, k.p2, k.p1, k.p2), 0);
  }
}

// The filter must answer nearly always away from ties: else a run would crawl.
TEST(ContactPredicates, FilterAnswersOrdinaryCases) {
  Random random;
  const auto before = exact::calls();
  for (int n = 0; n < 10000; ++n) {
    const auto any = [&] { return Vec2(random.uniform(-1, 1), random.uniform(-1, 1)); };
    const Case k{any(), any(), any(), any(), any(), any(), any()};
    overlap_sign(k.c, k.p1, k.p2);
    between(k.c, k.p1, k.p2);
    near_or_inside(k.c, k.p1, k.p2);
    within_depth(k.c, k.centroid, k.p1, k.p2);
    faces_edge(k.c, k.neighbour, k.p1, k.p2);
    compare_depth(k.c, k.p1, k.p2, k.q1, k.q2);
  }
  EXPECT_LE(exact::calls() - before, 2U);
}

}  // namespace
}  // namespace blocks::geometry
