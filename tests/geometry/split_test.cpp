#include "geometry/split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "validation/geometry/split_cases.hpp"
#include "validation/geometry/split_judge.hpp"

namespace blocks::geometry {
namespace {

using Numbers = std::vector<int>;

const Polygon square = {{0, 0}, {0, 2}, {2, 2}, {2, 0}};
// A U with legs of width 1, open at the top.
const Polygon channel = {{0, 0}, {0, 4}, {1, 4}, {1, 1},
                         {3, 1}, {3, 4}, {4, 4}, {4, 0}};

void expect_right(const Polygon& outline, const SplitLine& line, double min_area,
                  const Split& split) {
  EXPECT_EQ(validation::judge_split(outline, line, min_area, split), "");
}

Split cut(const Polygon& outline, const SplitLine& line, double min_area = 0.0) {
  Split split = split_outline(outline, line, min_area);
  expect_right(outline, line, min_area, split);
  return split;
}

TEST(SplitOutline, CutsASquareIntoHalves) {
  const Split split = cut(square, {{1, 1}, {0, 3}});
  ASSERT_EQ(split.fault, SplitFault::none);
  EXPECT_EQ(split.ends[0].place, Vec2(1, 0));
  EXPECT_EQ(split.ends[0].side, 3);
  EXPECT_EQ(split.ends[0].part, 0.5);
  EXPECT_EQ(split.ends[1].place, Vec2(1, 2));
  EXPECT_EQ(split.ends[1].side, 1);
  const SplitPiece &left = split.pieces[0], &right = split.pieces[1];
  EXPECT_EQ(left.outline, (Polygon{{0, 0}, {0, 2}, {1, 2}, {1, 0}}));
  EXPECT_EQ(left.corner, (Numbers{0, 1, -1, -1}));
  EXPECT_EQ(left.side, (Numbers{0, 1, -1, 3}));
  EXPECT_EQ(right.outline, (Polygon{{2, 2}, {2, 0}, {1, 0}, {1, 2}}));
  EXPECT_EQ(right.corner, (Numbers{2, 3, -1, -1}));
  EXPECT_EQ(right.side, (Numbers{2, 3, -1, 1}));
  EXPECT_EQ(left.area, 2.0);
  EXPECT_EQ(right.area, 2.0);
  EXPECT_EQ(split.certificate.interior_edges, 1);
  EXPECT_EQ(split.certificate.outline_edges, 6);
}

TEST(SplitOutline, CutsFromCornerToCorner) {
  const Split split = cut(square, {{5, 5}, {1, 1}});
  ASSERT_EQ(split.fault, SplitFault::none);
  EXPECT_EQ(split.pieces[0].corner, (Numbers{0, 1, 2}));
  EXPECT_EQ(split.pieces[0].side, (Numbers{0, 1, -1}));
  EXPECT_EQ(split.pieces[1].corner, (Numbers{0, 2, 3}));
  EXPECT_EQ(split.pieces[1].side, (Numbers{-1, 2, 3}));
}

TEST(SplitOutline, MovesACrossingOnlyIfItIsNearerThanTheLimit) {
  const SplitLine line{{0.25, 0}, {0, 1}, 0.25};
  EXPECT_EQ(cut(square, line).ends[0].corner, -1);
  const double more = std::nextafter(0.25, 1.0);
  const Split split = cut(square, {line.point, line.along, more});
  EXPECT_EQ(split.ends[0].corner, 0);
  EXPECT_EQ(split.ends[0].moved, 0.25);
  EXPECT_EQ(split.ends[0].side, -1);
  // Both ends have moved to the corners of one side.
  EXPECT_EQ(split.fault, SplitFault::unsound);
  EXPECT_FALSE(split.certificate.holds);
}

TEST(SplitOutline, MovesToTheLowerOfTwoEquallyNearCorners) {
  // The crossings are in the middle of sides 1 (corners 1, 2) and 3 (corners 3, 0).
  const Split split = cut(square, {{1, 0}, {0, 1}, 1.5});
  EXPECT_EQ(split.ends[0].corner, 0);
  EXPECT_EQ(split.ends[1].corner, 1);
}

TEST(SplitOutline, RefusesAChordWhoseEndsMoveToOneCorner) {
  const Split split = cut(square, {{0.1, 0}, {-1, 1}, 0.2});
  EXPECT_EQ(split.fault, SplitFault::unsound);
  EXPECT_EQ(split.certificate.fault, "both ends of the chord move to corner 1");
}

TEST(SplitOutline, FindsNoChordAlongASideOrAtACorner) {
  EXPECT_EQ(cut(square, {{0, 1}, {0, 1}}).fault, SplitFault::no_chord);
  EXPECT_EQ(cut(square, {{0, 2}, {1, 1}}).fault, SplitFault::no_chord);
  EXPECT_EQ(cut(square, {{3, 0}, {0, 1}}).fault, SplitFault::no_chord);
}

TEST(SplitOutline, CutsTheChordThatIsNearest) {
  // The line passes through both legs; the second one is nearer.
  const Split nearer = cut(channel, {{2.5, 3}, {1, 0}});
  EXPECT_EQ(nearer.ends[0].place, Vec2(3, 3));
  // Of two equally near chords it is the first in the direction of the line.
  EXPECT_EQ(cut(channel, {{2, 3}, {1, 0}}).ends[0].place, Vec2(0, 3));
  EXPECT_EQ(cut(channel, {{2, 3}, {-1, 0}}).ends[0].place, Vec2(4, 3));
}

TEST(SplitOutline, EndsChordsAtSidesInTheLine) {
  // The line follows side 3, from (1, 1) to (3, 1), between two chords.
  const Split split = cut(channel, {{3.5, 1}, {1, 0}});
  ASSERT_EQ(split.fault, SplitFault::none);
  EXPECT_EQ(split.ends[0].corner, 4);
  EXPECT_EQ(split.ends[1].place, Vec2(4, 1));
}

TEST(SplitOutline, EndsAChordAtATouchingCorner) {
  const Polygon notched = {{0, 0}, {0, 2}, {2, 2}, {1, 1}, {2, 0}};
  const Split split = cut(notched, {{1, 0.5}, {0, 1}});
  ASSERT_EQ(split.fault, SplitFault::none);
  EXPECT_EQ(split.ends[1].corner, 3);
  EXPECT_EQ(split.pieces[1].area, 0.5);
}

TEST(SplitOutline, RefusesAMovedChordThatLeavesTheOutline) {
  // A chord beside the notch moves to two corners, between which the notch lies.
  const Polygon notched = {{0, 0}, {0, 2}, {4, 2}, {4, 0}, {2, 1.5}};
  const Split split = cut(notched, {{0, 1.55}, {1, 0}, 1.7});
  EXPECT_EQ(split.fault, SplitFault::unsound);
  EXPECT_FALSE(split.certificate.holds);
  EXPECT_NE(split.certificate.fault, "");
}

TEST(SplitOutline, ComparesAreasExactly) {
  // The left piece has the area 2 (1 +- 1e-17), which rounds to 2.
  const SplitLine line{{1, 0}, {0, 1}};
  const auto from = [](double x) { return Polygon{{x, 0}, {x, 2}, {2, 2}, {2, 0}}; };
  EXPECT_EQ(cut(from(-1e-17), line, 2.0).fault, SplitFault::none);
  const Split split = cut(from(1e-17), line, 2.0);
  EXPECT_EQ(split.fault, SplitFault::small);
  EXPECT_EQ(split.pieces[0].area, 2.0);
  EXPECT_TRUE(split.certificate.holds);
}

TEST(SplitOutline, RoundsTowardsTheInside) {
  // Thirds are no doubles. The vertex is on the inner side of a slanted side.
  const Polygon triangle = {{0, 0}, {1, 3}, {3, 0}};
  const Split split = cut(triangle, {{0, 0.1}, {1, 0}});
  ASSERT_EQ(split.fault, SplitFault::none);
  EXPECT_LE(cross(triangle[1], split.ends[0].place), 0.0);
  EXPECT_GT(split.ends[0].place.x(), 0.1 / 3.0 * (1 - 1e-15));
}

TEST(SplitOutline, MovesACrossingThatRoundsToACorner) {
  // The line passes 1e-20 beside two corners, where doubles are 2e-16 apart.
  const Polygon outline = {{1, 0}, {1, 2}, {3, 2}, {3, 0}};
  const Split split = cut(outline, {{1, -1e-20}, {1, 1}});
  EXPECT_EQ(split.fault, SplitFault::none);
  EXPECT_EQ(split.ends[0].corner, 0);
  EXPECT_EQ(split.ends[1].corner, 2);
  EXPECT_EQ(split.ends[0].moved, 1e-20);
}

TEST(SplitOutline, AcceptsAnyFiniteNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(split_outline(square, {{1, 1}, {0, 0}}, 0).fault, SplitFault::no_chord);
  EXPECT_EQ(split_outline(square, {{1, nan}, {0, 1}}, 0).fault, SplitFault::no_chord);
  EXPECT_EQ(split_outline({{0, 0}, {1, 1}}, {{0, 0}, {0, 1}}, 0).fault,
            SplitFault::no_chord);
  EXPECT_EQ(split_outline(square, {{1, 1}, {0, 1}, infinity}, 0).fault,
            SplitFault::unsound);
  EXPECT_EQ(split_outline(square, {{1, 1}, {0, 1}}, infinity).fault, SplitFault::small);
  for (const double size : {1e300, 1e-300, 4e-324}) {
    Polygon outline;
    for (const Vec2& corner : square)
      outline.push_back(corner * (size == 1e300 ? 1e300 : 4 * size));
    const Vec2 middle = (outline[0] + outline[2]) / 2;
    EXPECT_EQ(cut(outline, {middle, {1, 2}}).fault, SplitFault::none) << size;
    EXPECT_EQ(cut(outline, {middle, {1e-320, 1e300}, size}).fault, SplitFault::none);
  }
}

// Laws that need no judge, on the random cases of the study.
template <class Law> void for_cases(std::uint64_t count, const Law& law) {
  for (std::size_t f = 0; f < validation::split_families().size(); ++f)
    for (std::uint64_t i = 0; i < count; ++i) {
      SCOPED_TRACE(std::string(validation::split_families()[f].name) + ':' +
                   std::to_string(i));
      law(validation::make_split_case(f, 1'000'000 + i));
    }
}

TEST(SplitOutline, OppositeDirectionSwapsThePieces) {
  int cuts = 0;
  for_cases(200, [&cuts](const validation::SplitCase& k) {
    const Split split = split_outline(k.outline, k.line, k.min_area);
    const SplitLine opposite{k.line.point, -k.line.along, k.line.near};
    const Split other = split_outline(k.outline, opposite, k.min_area);
    // Of two equally near chords, the other one may be the first.
    if (split.fault != SplitFault::none || other.fault != SplitFault::none ||
        split.ends[0].place != other.ends[1].place)
      return;
    ++cuts;
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_EQ(split.ends[i].moved, other.ends[1 - i].moved);
      EXPECT_EQ(split.pieces[i].outline, other.pieces[1 - i].outline);
      EXPECT_EQ(split.pieces[i].side, other.pieces[1 - i].side);
    }
  });
  EXPECT_GT(cuts, 500);
}

TEST(SplitOutline, ScalingByAPowerOfTwoIsExact) {
  for_cases(100, [](const validation::SplitCase& k) {
    const double scale = std::ldexp(1.0, 40);
    Polygon outline;
    for (const Vec2& corner : k.outline)
      outline.push_back(scale * corner);
    const SplitLine line{scale * k.line.point, k.line.along, scale * k.line.near};
    const Split split = split_outline(k.outline, k.line, k.min_area);
    const Split scaled = split_outline(outline, line, scale * scale * k.min_area);
    ASSERT_EQ(split.fault, scaled.fault);
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_EQ(Vec2(scale * split.ends[i].place), scaled.ends[i].place);
      EXPECT_EQ(scale * split.ends[i].moved, scaled.ends[i].moved);
      EXPECT_EQ(scale * scale * split.pieces[i].area, scaled.pieces[i].area);
      EXPECT_EQ(split.pieces[i].corner, scaled.pieces[i].corner);
    }
  });
}

TEST(SplitOutline, IsRightForRandomAndAwkwardLines) {
  std::array<int, 4> faults = {};
  for_cases(430, [&faults](const validation::SplitCase& k) {
    const Split split = split_outline(k.outline, k.line, k.min_area);
    ++faults[static_cast<std::size_t>(split.fault)];
    expect_right(k.outline, k.line, k.min_area, split);
  });
  for (const int count : faults)
    EXPECT_GT(count, 100);  // the cases show every kind of result
}

// A judge that accepts everything would make the tests above worthless.
TEST(SplitJudge, RefusesEverySpoiltResult) {
  const Polygon outline = {{0, 0}, {1, 3}, {3, 2.5}, {3, 0}};
  const SplitLine line{{1.2, 1.1}, {0.1, 1}, 0.01};
  const Split right = split_outline(outline, line, 0.5);
  ASSERT_EQ(right.fault, SplitFault::none);
  const auto refuses = [&](auto spoil) {
    Split split = right;
    spoil(split);
    return !validation::judge_split(outline, line, 0.5, split).empty();
  };
  EXPECT_FALSE(refuses([](Split&) {}));
  for (const SplitFault fault :
       {SplitFault::no_chord, SplitFault::small, SplitFault::unsound})
    EXPECT_TRUE(refuses([fault](Split& s) { s.fault = fault; }));
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_TRUE(refuses([k](Split& s) { s.ends[k].part += 1e-15; }));
    EXPECT_TRUE(refuses([k](Split& s) { s.ends[k].side ^= 2; }));
    EXPECT_TRUE(refuses([k](Split& s) { s.ends[k].moved = 1e-300; }));
    EXPECT_TRUE(refuses([k](Split& s) { s.ends[k].place.y() += 1e-15; }));
    EXPECT_TRUE(refuses([k](Split& s) { s.pieces[k].area *= 1 + 1e-15; }));
    EXPECT_TRUE(refuses([k](Split& s) { s.pieces[k].side[1] = 7; }));
    EXPECT_TRUE(refuses([k](Split& s) { s.pieces[k].corner[0] = -1; }));
    EXPECT_TRUE(refuses([k](Split& s) { s.pieces[k].outline[2].x() += 1e-15; }));
    EXPECT_TRUE(refuses([k](Split& s) {
      auto& piece = s.pieces[k].outline;
      std::rotate(piece.begin(), piece.begin() + 1, piece.end());
    }));
  }
  EXPECT_TRUE(refuses([](Split& s) { std::swap(s.ends[0], s.ends[1]); }));
  EXPECT_TRUE(refuses([](Split& s) { std::swap(s.pieces[0], s.pieces[1]); }));
  EXPECT_TRUE(refuses([](Split& s) { s.certificate.holds = false; }));
}

}  // namespace
}  // namespace blocks::geometry
