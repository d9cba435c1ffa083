// Symmetries and implications that hold between the contact predicates.
#include "geometry/contact_predicates.hpp"

#include "contact_judge.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blocks::geometry {
namespace {

/// Calls `visit` with many corners of walls and random corners, some of them turned.
template <class Visit> void for_many_cases(Visit&& visit) {
  Random random;
  for (int n = 0; n < 20000; ++n) {
    Case k = n % 2 ? wall(random) : random.any(1);
    if (n % 4 < 2) {
      const Vec2 turn = random.vector(1);
      k.transform([&](const Vec2& v) -> Vec2 {
        return {turn.x() * v.x() - turn.y() * v.y(),
                turn.y() * v.x() + turn.x() * v.y()};
      });
    }
    const bool is_whole = n % 4 == 3;
    ASSERT_NO_FATAL_FAILURE(visit(k, is_whole, random)) << n;
  }
}

TEST(ContactPredicates, OverlapSignChangesWhenTheEdgeIsReversed) {
  for_many_cases([](const Case& k, bool, Random&) {
    const int sign = overlap_sign(k.c, k.p1, k.p2);
    ASSERT_EQ(sign, -overlap_sign(k.c, k.p2, k.p1));
    ASSERT_EQ(sign, overlap_sign(k.p1, k.p2, k.c));
  });
}

TEST(ContactPredicates, ACornerInsideAnEdgeIsNearOrInside) {
  for_many_cases([](const Case& k, bool, Random&) {
    const int sign = overlap_sign(k.c, k.p1, k.p2);
    ASSERT_TRUE(sign < 0 || near_or_inside(k.c, k.p1, k.p2));
    ASSERT_TRUE(near_or_inside(k.c, k.p1, k.p2) || near_or_inside(k.c, k.p2, k.p1));
  });
}

TEST(ContactPredicates, BetweenDoesNotDependOnTheSenseOfTheEdge) {
  for_many_cases([](const Case& k, bool, Random&) {
    ASSERT_EQ(between(k.c, k.p1, k.p2), between(k.c, k.p2, k.p1));
    const bool well = well_between(k.c, k.p1, k.p2);
    ASSERT_EQ(well, well_between(k.c, k.p2, k.p1));
    ASSERT_TRUE(!well || between(k.c, k.p1, k.p2));
  });
}

TEST(ContactPredicates, ComparisonsOfDepthsAreAntisymmetric) {
  for_many_cases([](const Case& k, bool, Random&) {
    const int nearer = compare_depths(k.c, k.p1, k.p2, k.c, k.q1, k.q2);
    ASSERT_EQ(nearer, -compare_depths(k.c, k.q1, k.q2, k.c, k.p1, k.p2));
    const int deeper = compare_depths(k.c, k.p1, k.p2, k.neighbour, k.q1, k.q2);
    ASSERT_EQ(deeper, -compare_depths(k.neighbour, k.q1, k.q2, k.c, k.p1, k.p2));
  });
}

TEST(ContactPredicates, DepthsBelowTheSameEdgeOrCornerAreEqual) {
  for_many_cases([](const Case& k, bool, Random&) {
    ASSERT_EQ(compare_depths(k.c, k.p1, k.p2, k.c, k.p1, k.p2), 0);
    ASSERT_EQ(compare_depths(k.p2, k.p1, k.p2, k.p2, k.p2, k.q2), 0);
  });
}

TEST(ContactPredicates, TurnSignChangesWhenOneEdgeIsReversed) {
  for_many_cases([](const Case& k, bool, Random&) {
    const int turn = turn_sign(k.p1, k.p2, k.c, k.neighbour);
    ASSERT_EQ(turn, -turn_sign(k.c, k.neighbour, k.p1, k.p2));
    ASSERT_EQ(turn, -turn_sign(k.p1, k.p2, k.neighbour, k.c));
  });
}

TEST(ContactPredicates, EdgesFaceEachOtherMutually) {
  for_many_cases([](const Case& k, bool, Random&) {
    const bool face = edges_face(k.p1, k.p2, k.c, k.neighbour);
    ASSERT_EQ(face, edges_face(k.c, k.neighbour, k.p1, k.p2));
    ASSERT_FALSE(face && edges_face(k.p1, k.p2, k.neighbour, k.c));
  });
}

TEST(ContactPredicates, ComparisonsOfSlopesAreAntisymmetric) {
  for_many_cases([](const Case& k, bool, Random&) {
    const int steeper = compare_slopes(k.p1, k.p2, k.q1, k.q2, k.c, k.neighbour);
    ASSERT_EQ(steeper, -compare_slopes(k.p1, k.p2, k.c, k.neighbour, k.q1, k.q2));
    ASSERT_EQ(steeper, compare_slopes(k.p1, k.p2, k.q2, k.q1, k.neighbour, k.c));
    ASSERT_EQ(compare_slopes(k.p1, k.p2, k.q1, k.q2, k.q2, k.q1), 0);
  });
}

TEST(ContactPredicates, NoSlopeIsLessThanThatOfAParallelEdge) {
  for_many_cases([](const Case& k, bool, Random&) {
    ASSERT_TRUE(turn_sign(k.p1, k.p2, k.c, k.neighbour) != 0 ||
                compare_slopes(k.p1, k.p2, k.q1, k.q2, k.c, k.neighbour) >= 0);
  });
}

// Scaling by a power of two is exact, and so is moving bricks by whole numbers.
TEST(ContactPredicates, DoNotDependOnScaleAndOrigin) {
  for_many_cases([](const Case& k, bool is_whole, Random& random) {
    Case m = k;
    const double scale = std::ldexp(1, random.whole(-200, 200));
    const Vec2 shift = is_whole ? Vec2(1e6, -3e6) : Vec2(0, 0);
    m.transform([&](const Vec2& v) -> Vec2 { return scale * (v + shift); });
    ASSERT_EQ(overlap_sign(m.c, m.p1, m.p2), overlap_sign(k.c, k.p1, k.p2));
    ASSERT_EQ(between(m.c, m.p1, m.p2), between(k.c, k.p1, k.p2));
    ASSERT_EQ(faces_edge(m.c, m.neighbour, m.p1, m.p2),
              faces_edge(k.c, k.neighbour, k.p1, k.p2));
    ASSERT_EQ(well_between(m.c, m.p1, m.p2), well_between(k.c, k.p1, k.p2));
    ASSERT_EQ(turn_sign(m.p1, m.p2, m.c, m.neighbour),
              turn_sign(k.p1, k.p2, k.c, k.neighbour));
    ASSERT_EQ(edges_face(m.p1, m.p2, m.c, m.neighbour),
              edges_face(k.p1, k.p2, k.c, k.neighbour));
    ASSERT_EQ(compare_depths(m.c, m.p1, m.p2, m.neighbour, m.q1, m.q2),
              compare_depths(k.c, k.p1, k.p2, k.neighbour, k.q1, k.q2));
    ASSERT_EQ(compare_slopes(m.p1, m.p2, m.q1, m.q2, m.c, m.neighbour),
              compare_slopes(k.p1, k.p2, k.q1, k.q2, k.c, k.neighbour));
  });
}

// Exact arithmetic is slow, so the filters must decide all cases that are no near ties.
TEST(ContactPredicates, UseExactArithmeticNextToTiesOnly) {
  Random random;
  const auto before = exact::calls();
  for (int n = 0; n < 10000; ++n) {
    const Case k = random.any(1);
    overlap_sign(k.c, k.p1, k.p2);
    near_or_inside(k.c, k.p1, k.p2);
    between(k.c, k.p1, k.p2);
    faces_edge(k.c, k.neighbour, k.p1, k.p2);
    compare_depths(k.c, k.p1, k.p2, k.neighbour, k.q1, k.q2);
    well_between(k.c, k.p1, k.p2);
    turn_sign(k.p1, k.p2, k.c, k.neighbour);
    edges_face(k.p1, k.p2, k.c, k.neighbour);
    compare_slopes(k.p1, k.p2, k.q1, k.q2, k.c, k.neighbour);
  }
  EXPECT_LE(exact::calls() - before, 4U);
  const auto now = exact::calls();
  overlap_sign({1, 1}, {0, 0}, {2, 2});
  EXPECT_EQ(exact::calls(), now + 1);
}

}  // namespace
}  // namespace blocks::geometry
