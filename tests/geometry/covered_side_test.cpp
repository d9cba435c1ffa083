// Covered sides of the contact rule have the answers of an oracle on rationals.
#include "geometry/covered_side.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "covered_side_oracle.hpp"

namespace blocks::geometry {
namespace {

using namespace covering_tests;

using Counts = std::map<std::string, int>;

/// Compares the answer with the oracle and counts the properties of the scene.
void judge(const Scene& s, Counts& counts) {
  if (!s.is_proper())
    return;
  const auto before = exact::covering_calls();
  const Cover found = covering_of(s);
  counts["rationals"] += exact::covering_calls() > before;
  const Oracle oracle(s);
  oracle.count(counts);
  const Cover right = oracle.answer();
  ASSERT_TRUE(found.neighbour == right.neighbour && found.side == right.side)
      << "found " << found.neighbour << ", " << found.side << ", right "
      << right.neighbour << ", " << right.side << "\n"
      << text(s);
}

/// Requires at least these counts, so that the scenes reach every condition of the
/// rule.
void require(const Counts& counts, const Counts& least) {
  for (const auto& [name, count] : least)
    EXPECT_GE(counts.contains(name) ? counts.at(name) : 0, count) << name;
  for (const auto& [name, count] : counts)
    testing::Test::RecordProperty(name,
                                  count);  // The log of the test run lists the counts.
}

// Half-integers are turned by Pythagorean angles and scaled by powers of two. Every tie
// of the rule occurs exactly.
TEST(CoveredSide, AgreesWithTheOracleOnExactTiesOfBricks) {
  Random random;
  Counts counts;
  constexpr std::array<std::pair<int, int>, 4> turns{
      {{1, 0}, {0, 1}, {4, 3}, {-5, 12}}};
  for (int n = 0; n < 24000; ++n) {
    Scene s = bricks(random);
    if (random.coin())
      s = mirrored(s);
    const auto [a, b] = turns[static_cast<std::size_t>(n) % 4];
    turn(s, a, b, Vec2(random.whole(-9, 9), random.whole(-9, 9)));
    const double scale = std::ldexp(1, random.whole(-40, 40));
    s.transform([&](const Vec2& v) -> Vec2 { return scale * v; });
    ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << n;
  }
  require(counts, {{"covered", 4000},
                   {"not covered", 4000},
                   {"no interval", 4000},
                   {"several cover", 1500},
                   {"equal rivals", 500},
                   {"gap equals h", 1000},
                   {"overlap equals h", 50},
                   {"reach equals h", 700},
                   {"half of the stretch", 200},
                   {"half of the interval", 200},
                   {"face", 700},
                   {"gap", 250},
                   {"reach", 900},
                   {"inside", 30},
                   {"stretch", 60},
                   {"interval", 30},
                   {"rationals", 500}});
}

// The bricks are turned by any angle and moved away from the origin. Rounding of their
// corners breaks the ties.
TEST(CoveredSide, AgreesWithTheOracleOnTurnedAndMovedBricks) {
  Random random;
  Counts counts;
  for (int n = 0; n < 10000; ++n) {
    Scene s = bricks(random);
    const double angle = random.uniform(0, 6.3);
    turn(s, std::cos(angle), std::sin(angle),
         random.vector(std::pow(10.0, random.whole(0, 9))));
    ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << n;
  }
  require(counts, {{"covered", 1500},
                   {"not covered", 2000},
                   {"several cover", 500},
                   {"touch", 50},
                   {"reach", 350},
                   {"rationals", 350}});
}

TEST(CoveredSide, AgreesWithTheOracleOnRandomPolygons) {
  Random random;
  Counts counts;
  for (int n = 0; n < 5000; ++n) {
    Scene s = random_scene(random);
    if (n % 2)
      s = mirrored(s);
    ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << n;
  }
  require(counts,
          {{"covered", 1000}, {"not covered", 1500}, {"face", 600}, {"gap", 60}});
}

// The wedge above the side opens by ten degrees, up to differences far below rounding.
// All other conditions hold, so the answer is whether the two sides face each other.
TEST(CoveredSide, AgreesWithTheOracleNextToTenDegrees) {
  Random random;
  Counts counts;
  for (const auto& [p, q] : fractions_near_tan10(0x1p44))
    for (const auto& [a, b] : {std::pair(1, 0), std::pair(4, 3), std::pair(-5, 12)})
      for (const bool mirror : {false, true}) {
        const double scale = std::ldexp(1, 2 - std::ilogb(q));
        Scene s;
        s.own = {{0, 0}, {4, 0}, {4, -3}, {0, -3}};
        s.other = box(-1, -1, 2, 8);
        s.neighbours = {{{0, 0}, {0, 6}, {scale * q, scale * p}}};
        if (mirror)
          s = mirrored(s);
        turn(s, a, b, {0, 0});
        ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << p << '/' << q;
      }
  require(counts, {{"covered", 80}, {"face", 80}, {"rationals", 40}});
}

// Magnitudes go from 1e-150 to 1e150 and beyond, equal for all corners or mixed. Mixed
// magnitudes make polygons that are not convex; the rule still has one answer for them.
TEST(CoveredSide, AgreesWithTheOracleForAnyMagnitude) {
  Random random;
  Counts counts;
  for (int n = 0; n < 1200; ++n) {
    Scene s = n % 2 ? bricks(random) : random_scene(random);
    const double angle = random.uniform(0, 6.3);
    turn(s, std::cos(angle), std::sin(angle), random.vector(1));
    const int most = n % 8 < 4 ? 500 : 1020;
    const double size = std::ldexp(1, random.whole(-most, most));
    s.transform([&](const Vec2& v) -> Vec2 { return size * v; });
    if (n % 4 == 3)
      s.transform([&](const Vec2& v) -> Vec2 {
        return v * std::ldexp(1, random.whole(-most, most));
      });
    ASSERT_NO_FATAL_FAILURE(judge(s, counts)) << n;
  }
  require(counts, {{"covered", 150}, {"not covered", 250}, {"rationals", 350}});
}

// The first side covers a third of the stretch and the last one a half. Whether the one
// between them covers the whole stretch is a tie that interval arithmetic cannot
// decide.
TEST(CoveredSide, ComparesALaterSideWithAnUndecidedOne) {
  Scene s;
  s.own = {{0, 0}, {6, 0}, {6, -3}, {0, -3}};
  s.other = box(-1, -1, 5, 10);
  s.neighbours = {box(0, 0, 2, 3), box(0, 5, 6, 8), box(2, 0, 5, 3)};
  const auto before = exact::covering_calls();
  EXPECT_EQ(covering_of(s).neighbour, 1);
  EXPECT_GT(exact::covering_calls(), before) << "the case is too easy";
}

/// Calls `visit` with many scenes of bricks and of random polygons.
template <class Visit> void for_many_scenes(Visit&& visit) {
  Random random;
  int covered = 0;
  for (int n = 0; n < 10000; ++n) {
    const Scene s = n % 2 ? bricks(random) : random_scene(random);
    const Cover found = covering_of(s);
    covered += static_cast<bool>(found);
    ASSERT_NO_FATAL_FAILURE(visit(s, found, random)) << text(s);
  }
  EXPECT_GT(covered, 1000);
}

TEST(CoveredSide, IsTheSameInTheMirrorImage) {
  for_many_scenes([](const Scene& s, const Cover& found, Random&) {
    ASSERT_EQ(covering_of(mirrored(s)).neighbour, found.neighbour);
  });
}

TEST(CoveredSide, DoesNotDependOnTheScale) {
  for_many_scenes([](const Scene& s, const Cover& found, Random& random) {
    Scene scaled = s;
    const double scale = std::ldexp(1, random.whole(-200, 200));
    scaled.transform([&](const Vec2& v) -> Vec2 { return scale * v; });
    ASSERT_EQ(covering_of(scaled).neighbour, found.neighbour);
    ASSERT_EQ(covering_of(scaled).side, found.side);
  });
}

// The order of the neighbours only decides which of several equal ones is named.
TEST(CoveredSide, DoesNotDependOnTheOrderOfNeighbours) {
  for_many_scenes([](const Scene& s, const Cover& found, Random&) {
    Scene back = s;
    std::reverse(back.neighbours.begin(), back.neighbours.end());
    ASSERT_EQ(static_cast<bool>(covering_of(back)), static_cast<bool>(found));
  });
}

TEST(CoveredSide, IsNotCoveredWithoutNeighbours) {
  for_many_scenes([](const Scene& s, const Cover&, Random&) {
    Scene alone = s;
    alone.neighbours.clear();
    ASSERT_FALSE(covering_of(alone));
  });
}

}  // namespace
}  // namespace blocks::geometry
