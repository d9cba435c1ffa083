// The contact predicates agree with an independent judge on rationals of boost.
#include "geometry/contact_predicates.hpp"

#include "contact_judge.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace blocks::geometry {
namespace {

/// Compares the filtered and the exact version with the judge.
#define EXPECT_EQUAL(right, name, ...)                                                 \
  do {                                                                                 \
    const auto expected = right;                                                       \
    EXPECT_EQ(name(__VA_ARGS__), expected) << #name;                                   \
    EXPECT_EQ(exact::name(__VA_ARGS__), expected) << "exact::" #name;                  \
  } while (false)
#define EXPECT_RIGHT(name, ...) EXPECT_EQUAL(Judge::name(k), name, __VA_ARGS__)

/// Compares all predicates with the judge.
void judge(const Case& k) {
  EXPECT_RIGHT(overlap_sign, k.c, k.p1, k.p2);
  EXPECT_RIGHT(near_or_inside, k.c, k.p1, k.p2);
  EXPECT_RIGHT(between, k.c, k.p1, k.p2);
  EXPECT_RIGHT(faces_edge, k.c, k.neighbour, k.p1, k.p2);
  EXPECT_RIGHT(compare_depths, k.c, k.p1, k.p2, k.neighbour, k.q1, k.q2);
  EXPECT_EQUAL(Judge::compare_depths(k, k.c), compare_depths, k.c, k.p1, k.p2, k.c,
               k.q1, k.q2);
  EXPECT_EQUAL(Judge::turn_from_centroid(k), turn_sign, k.centroid, k.c, k.p1, k.p2);
  EXPECT_RIGHT(well_between, k.c, k.p1, k.p2);
  if (k.c != k.neighbour) {
    EXPECT_RIGHT(turn_sign, k.p1, k.p2, k.c, k.neighbour);
    EXPECT_RIGHT(edges_face, k.p1, k.p2, k.c, k.neighbour);
    EXPECT_RIGHT(compare_slopes, k.p1, k.p2, k.q1, k.q2, k.c, k.neighbour);
  }
  const auto depth_below = [](const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return filter::depth(c, p1, p2, filter::per_length(p1, p2));
  };
  const filter::Estimate d = depth_below(k.c, k.p1, k.p2);
  const filter::Estimate other = depth_below(k.neighbour, k.q1, k.q2);
  if (d.positive() || d.negative()) {
    EXPECT_EQ(filter::sign(d.value), Judge::overlap_sign(k)) << "depth";
  }
  const double bound = (1.0 + 1e-9) * (d.bound + other.bound);
  if (std::abs(d.value - other.value) > bound) {
    EXPECT_EQ(filter::sign(d.value - other.value), Judge::compare_depths(k)) << "depth";
  }
  ASSERT_FALSE(testing::Test::HasFailure())
      << std::hexfloat << "c " << k.c.x() << ' ' << k.c.y() << " p1 " << k.p1.x() << ' '
      << k.p1.y() << " p2 " << k.p2.x() << ' ' << k.p2.y() << " q1 " << k.q1.x() << ' '
      << k.q1.y() << " q2 " << k.q2.x() << ' ' << k.q2.y() << " g " << k.centroid.x()
      << ' ' << k.centroid.y() << " n " << k.neighbour.x() << ' ' << k.neighbour.y();
}

constexpr std::array<std::pair<int, int>, 4> pythagorean{
    {{4, 3}, {12, 5}, {21, 20}, {1, 0}}};

// Bricks are turned by an angle and moved away. As in every wall at the start of a run,
// corners are on edges up to rounding.
TEST(ContactPredicates, AgreeWithTheJudgeInTurnedAndMovedWalls) {
  Random random;
  int misjudged = 0;
  for (const double offset : {0.0, 1.0, 1e3, 1e6, 1e9, 1e12, 1e15})
    for (int n = 0; n < 2000; ++n) {
      const double angle = random.uniform(0, 6.3);
      const double cosine = std::cos(angle), sine = std::sin(angle);
      const Vec2 origin = random.vector(offset);
      Case k = wall(random);
      k.transform([&](const Vec2& v) {
        return Vec2(origin.x() + (cosine * v.x() - sine * v.y()),
                    origin.y() + (sine * v.x() + cosine * v.y()));
      });
      if (k.p1 == k.p2 || k.q1 == k.q2)
        continue;
      ASSERT_NO_FATAL_FAILURE(judge(k)) << "offset " << offset << " case " << n;
      // This is equation (19) as printed, in absolute coordinates.
      const double printed = (k.p1.x() * k.c.y() - k.c.x() * k.p1.y()) +
                             (k.c.x() * k.p2.y() - k.p2.x() * k.c.y()) +
                             (k.p2.x() * k.p1.y() - k.p1.x() * k.p2.y());
      misjudged += filter::sign(printed) != overlap_sign(k.c, k.p1, k.p2);
    }
  EXPECT_GT(misjudged, 4000) << "these walls are too easy to prove anything";
}

// Rotations by Pythagorean angles keep whole numbers whole, so that ties are exact. The
// predicates decide most of them without multiprecision arithmetic.
TEST(ContactPredicates, AgreeWithTheJudgeOnExactTies) {
  Random random;
  int on_line = 0, equally_deep = 0, as_deep_as_centroid = 0, parallel = 0;
  for (int n = 0; n < 8000; ++n) {
    const auto [cosine, sine] = pythagorean[static_cast<std::size_t>(n) % 4];
    const double a = cosine, b = sine;  // Clang 14 cannot capture structured bindings.
    const double scale = std::ldexp(1, random.whole(-40, 40));
    const Vec2 shift(random.whole(-1000, 1000), random.whole(-1000, 1000));
    Case k = wall(random);
    k.transform([&](const Vec2& v) -> Vec2 {
      return scale * (Vec2(a * v.x() - b * v.y(), b * v.x() + a * v.y()) + shift);
    });
    if (n % 8 == 0)
      k.c = k.centroid + (k.p2 - k.p1);
    ASSERT_NO_FATAL_FAILURE(judge(k)) << n;
    const auto before = exact::multiprecision_calls();
    on_line += overlap_sign(k.c, k.p1, k.p2) == 0;
    as_deep_as_centroid += turn_sign(k.centroid, k.c, k.p1, k.p2) == 0;
    parallel += turn_sign(k.p1, k.p2, k.c, k.neighbour) == 0;
    EXPECT_EQ(exact::multiprecision_calls(), before) << n;
    equally_deep += compare_depths(k.c, k.p1, k.p2, k.c, k.q1, k.q2) == 0;
  }
  EXPECT_GT(on_line, 1000);
  EXPECT_GT(equally_deep, 300);
  EXPECT_GT(as_deep_as_centroid, 900);
  EXPECT_GT(parallel, 3000);
}

// Corners are a few doubles from each limit. The limits are the line, both ends of the
// slack, the depth of the centroid, and the bisector of two edges.
TEST(ContactPredicates, AgreeWithTheJudgeNextToEveryLimit) {
  Random random;
  for (int n = 0; n < 16000; ++n) {
    Case k = random.any(1);
    if (n % 2)
      k.q1 = k.p2;
    const Vec2 e = k.p2 - k.p1, left(-e.y(), e.x());
    const double s = random.uniform(0, 1);
    switch (n % 8) {
    case 0:
      k.c = k.p1 + s * e;
      break;
    case 1:
      k.c = k.p1 + s * e + contact_slack * left;
      break;
    case 2:  // The corner is beyond an end, or well between the ends.
      k.c = k.p1 + (random.coin() ? 1 : -1) * contact_slack * e + s * left;
      break;
    case 3:
      k.c = k.p2 + (random.coin() ? 1 : -1) * contact_slack * e + s * left;
      break;
    case 4:
      k.c = k.centroid + s * e;
      break;
    case 5:
      k.c = k.p2 + s * (e.normalized() + (k.q2 - k.q1).normalized());
      break;
    case 6:
      k.c = s < 0.5 ? k.p1 : k.p2;
      break;
    default:
      k.c = k.p2 + s * (e.normalized() - (k.q2 - k.q1).normalized());
    }
    k.c = random.nudge(k.c, 3);
    ASSERT_NO_FATAL_FAILURE(judge(k)) << n;
  }
}

// Up to a few doubles, depths below two edges are equal, edges are parallel, or edges
// are turned by the same angle to either side. Most cases need exact arithmetic, and
// plain doubles decide some of them wrongly.
TEST(ContactPredicates, AgreeWithTheJudgeWhenTwoEdgesNearlyTie) {
  Random random;
  int depths = 0, turns = 0, slopes = 0;
  unsigned long long undecided = 0;
  for (int n = 0; n < 9000; ++n) {
    Case k = random.any(1);
    const Vec2 e = k.p2 - k.p1, f = k.q2 - k.q1;
    const Vec2 right = Vec2(f.y(), -f.x()).normalized();
    const double angle = random.uniform(-3, 3);
    switch (n % 3) {
    case 0:
      k.neighbour =
          k.q1 + random.uniform(0, 1) * f + cross(k.c - k.p1, e) / e.norm() * right;
      break;
    case 1:
      k.neighbour = k.c + random.uniform(-1, 1) * e;
      break;
    default:
      k.q2 = k.q1 + random.uniform(0.1, 2) *
                        Vec2(e.x() * std::cos(angle) - e.y() * std::sin(angle),
                             e.y() * std::cos(angle) + e.x() * std::sin(angle));
      k.neighbour = k.c + random.uniform(0.1, 2) *
                              Vec2(e.x() * std::cos(angle) + e.y() * std::sin(angle),
                                   e.y() * std::cos(angle) - e.x() * std::sin(angle));
    }
    k.neighbour = random.nudge(k.neighbour, 2);
    ASSERT_NO_FATAL_FAILURE(judge(k)) << n;
    const auto before = exact::calls();
    const auto depth =
        filter::depth_difference(k.c, k.p1, k.p2, k.neighbour, k.q1, k.q2);
    const auto turn = filter::turn(k.p1, k.p2, k.c, k.neighbour);
    const auto slope =
        filter::slope_difference(k.p1, k.p2, k.q1, k.q2, k.c, k.neighbour);
    if (n % 3 == 0)
      compare_depths(k.c, k.p1, k.p2, k.neighbour, k.q1, k.q2);
    else if (n % 3 == 1)
      turn_sign(k.p1, k.p2, k.c, k.neighbour);
    else
      compare_slopes(k.p1, k.p2, k.q1, k.q2, k.c, k.neighbour);
    undecided += exact::calls() - before;
    depths += filter::sign(depth.value) != Judge::compare_depths(k);
    turns += filter::sign(turn.value) != Judge::turn_sign(k);
    slopes += filter::sign(slope.value) != Judge::compare_slopes(k);
  }
  EXPECT_GT(undecided, 7000U);
  EXPECT_GT(depths, 500);
  EXPECT_GT(turns, 200);
  EXPECT_GT(slopes, 500);
}

// Corners of very different magnitude are on a line through the origin. No difference
// of two of them is a double, and the last bit of the smallest decides.
TEST(ContactPredicates, AgreeWithTheJudgeWhenDifferencesAreInexact) {
  Random random;
  int on_line = 0;
  for (int n = 0; n < 6000; ++n) {
    const Vec2 along(random.whole(1, 1 << 26), random.whole(1, 1 << 26));
    Case k = random.any(1);
    k.c = along * random.whole(1, 9);
    k.p1 = along * std::ldexp(random.whole(1, 9), random.whole(-64, -40));
    k.p2 = along * -random.whole(1, 9);
    k.centroid = random.nudge(along * std::ldexp(1, random.whole(-64, -40)), 1);
    if (n % 3)
      k.p1 = random.nudge(k.p1, 2);
    if (n % 2)
      std::swap(k.c, k.p1);
    ASSERT_NO_FATAL_FAILURE(judge(k)) << n;
    on_line += overlap_sign(k.c, k.p1, k.p2) == 0;
  }
  EXPECT_GT(on_line, 2000);
  EXPECT_LT(on_line, 4000);
}

// Where a limit is a double, a corner on it is inside, and the next double is outside.
TEST(ContactPredicates, CountTheLimitAsInside) {
  for (const int power : {-300, -20, 0, 20, 300}) {
    const double length = std::ldexp(1, power), slack = contact_slack * length;
    const double more = std::nextafter(slack, HUGE_VAL);
    const Vec2 p1(0, 0), p2(length, 0);
    EXPECT_TRUE(near_or_inside({0.5 * length, slack}, p1, p2));
    EXPECT_FALSE(near_or_inside({0.5 * length, more}, p1, p2));
    EXPECT_TRUE(between({-slack, length}, p1, p2));
    EXPECT_FALSE(between({-more, length}, p1, p2));
    EXPECT_TRUE(between({slack, length}, {-length, 0}, {0, 0}));
    EXPECT_FALSE(between({more, length}, {-length, 0}, {0, 0}));
    const double less = std::nextafter(slack, 0);
    EXPECT_TRUE(well_between({slack, length}, p1, p2));
    EXPECT_FALSE(well_between({less, length}, p1, p2));
    EXPECT_TRUE(well_between({-slack, length}, {-length, 0}, {0, 0}));
    EXPECT_FALSE(well_between({-less, length}, {-length, 0}, {0, 0}));
  }
}

// Tangents differ from -10 degrees by less than rounding, so that only the cubic
// decides. Both answers occur, and plain doubles decide some cases wrongly.
TEST(ContactPredicates, AgreeWithTheJudgeOnTangentsNextToTenDegrees) {
  Random random;
  const auto fractions = fractions_near_tan10(0x1p47);
  ASSERT_GT(fractions.size(), 40U);
  int facing = 0, all = 0, misjudged = 0;
  for (const auto& [p, q] : fractions)
    for (const auto& [a, b] : pythagorean)
      for (int n = 0; n < 16; ++n) {
        const double scale = std::ldexp(1, random.whole(-60, 60));
        const double e_scale = std::ldexp(random.whole(1, 9), random.whole(-60, 60));
        Case k = random.any(1);
        k.c = k.p1 = {0, 0};
        k.p2 = e_scale * Vec2(a, b);
        k.neighbour = scale * Vec2(a * q + b * p, b * q - a * p);
        if (n % 4 == 3)  // The angle is the same on the other side of the normal.
          k.neighbour = scale * Vec2(-a * q + b * p, -b * q - a * p);
        if (n % 4 == 2)
          k.neighbour = random.nudge(k.neighbour, 1);
        EXPECT_RIGHT(faces_edge, k.c, k.neighbour, k.p1, k.p2);
        ASSERT_FALSE(HasFailure()) << p << '/' << q;
        const bool ours = faces_edge(k.c, k.neighbour, k.p1, k.p2);
        const Vec2 e = k.p2 - k.p1, t = k.neighbour - k.c;
        const double sine = cross(e, t) / (e.norm() * t.norm());
        misjudged += ours != (sine >= -0.17364817766693036);
        facing += ours;
        ++all;
      }
  EXPECT_GT(facing, all / 4);
  EXPECT_LT(facing, 3 * all / 4);
  EXPECT_GT(misjudged, all / 20);
}

// Two edges run against each other. Their angle approaches ten degrees from above and
// from below, and to either side.
TEST(ContactPredicates, AgreeWithTheJudgeOnEdgesNextToTenDegrees) {
  Random random;
  int facing = 0, all = 0, misjudged = 0;
  unsigned long long undecided = 0;
  for (const auto& [p, q] : fractions_near_tan10(0x1p47))
    for (const auto& [a, b] : pythagorean)
      for (int n = 0; n < 8; ++n) {
        const double way = n % 2 ? 1 : -1;
        Case k = random.any(1);
        k.c = k.p1 = {0, 0};
        k.p2 = std::ldexp(random.whole(1, 9), random.whole(-60, 60)) * Vec2(a, b);
        k.neighbour = -std::ldexp(1, random.whole(-60, 60)) *
                      Vec2(a * q - way * b * p, b * q + way * a * p);
        if (n % 4 >= 2)
          k.neighbour = random.nudge(k.neighbour, 1);
        EXPECT_RIGHT(edges_face, k.p1, k.p2, k.c, k.neighbour);
        EXPECT_FALSE(edges_face(k.p1, k.p2, k.neighbour, k.c));
        ASSERT_FALSE(HasFailure()) << p << '/' << q;
        const auto before = exact::calls();
        const bool ours = edges_face(k.p1, k.p2, k.c, k.neighbour);
        undecided += exact::calls() - before;
        misjudged +=
            ours != (filter::edges_face(k.p1, k.p2, k.c, k.neighbour).value >= 0);
        facing += ours;
        ++all;
      }
  EXPECT_GT(facing, all / 4);
  EXPECT_LT(facing, 3 * all / 4);
  EXPECT_GT(misjudged, all / 20);
  EXPECT_GT(undecided, static_cast<unsigned>(all / 2));
}

// Magnitudes go from the smallest subnormal to near overflow, equal for all corners or
// mixed. The filters must leave such corners to exact arithmetic.
TEST(ContactPredicates, AgreeWithTheJudgeUnderUnderflowAndOverflow) {
  Random random;
  const auto judge_proper = [](const Case& k) {
    if (k.p1 != k.p2 && k.q1 != k.q2)
      judge(k);
  };
  for (int n = 0; n < 1000; ++n) {
    const double size = std::ldexp(1, random.whole(-1074, 1023));
    Case same = random.any(1);
    same.transform([&](const Vec2& v) -> Vec2 { return v * size; });
    ASSERT_NO_FATAL_FAILURE(judge_proper(same)) << "one size, case " << n;
    Case mixed = random.any(1);
    mixed.transform([&](const Vec2& v) -> Vec2 {
      return v * std::ldexp(1, random.whole(-1074, 1023));
    });
    ASSERT_NO_FATAL_FAILURE(judge_proper(mixed)) << "mixed sizes, case " << n;
    Case bricks = wall(random);
    const Vec2 turn = size * random.vector(0.0625);
    bricks.transform([&](const Vec2& v) -> Vec2 {
      return {turn.x() * v.x() - turn.y() * v.y(), turn.y() * v.x() + turn.x() * v.y()};
    });
    ASSERT_NO_FATAL_FAILURE(judge_proper(bricks)) << "wall, case " << n;
  }
}

// The product of the two lengths is an ordinary double, but the square of one is zero.
TEST(ContactPredicates, AgreeWithTheJudgeWhenOneSquareUnderflows) {
  Random random;
  for (const double degrees : {-9.9, -10.1}) {
    Case k = random.any(1);
    const double angle = degrees / 180 * boost::math::constants::pi<double>();
    k.c = k.p1 = {0, 0};
    k.p2 = {1e-180, 0};
    k.neighbour = {1e100 * std::cos(angle), 1e100 * std::sin(angle)};
    ASSERT_NO_FATAL_FAILURE(judge(k)) << degrees;
    k.neighbour = Vec2(-k.neighbour.x(), k.neighbour.y());
    ASSERT_NO_FATAL_FAILURE(judge(k)) << "against the edge, " << degrees;
  }
}

}  // namespace
}  // namespace blocks::geometry
