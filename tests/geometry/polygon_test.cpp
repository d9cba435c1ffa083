#include "geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "layers.hpp"

namespace blocks::geometry {
namespace {

struct Case {
  const char* name;
  Polygon outline;
  OutlineFault fault;
  int first;
  int second;
};

TEST(Outline, ReportsItsFaultAndTheCornersConcerned) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Case& c : {
           Case{"two corners", {{0, 0}, {1, 0}}, OutlineFault::too_few_corners, -1, -1},
           Case{"nan", {{0, 0}, {0, nan}, {1, 0}}, OutlineFault::not_finite, 1, -1},
           Case{"repeated",
                {{0, 0}, {0, 1}, {1, 1}, {0, 1}},
                OutlineFault::repeated_corner,
                1,
                3},
           Case{
               "line", {{0, 0}, {1, 1}, {3, 3}, {2, 2}}, OutlineFault::no_area, -1, -1},
           Case{"bow-tie",
                {{0, 0}, {1, 1}, {1, 0}, {0, 1}},
                OutlineFault::self_crossing,
                0,
                2},
           Case{"spike",
                {{0, 0}, {0, 1}, {0, 3}, {0, 2}, {1, 0}},
                OutlineFault::self_crossing,
                1,
                2},
           Case{"corner on a side",
                {{0, 0}, {0, 2}, {2, 2}, {1, 0}, {2, 0}, {2, -1}, {1, 0.0625}, {0, -1}},
                OutlineFault::self_crossing,
                2,
                5},
           Case{"pentagram",
                {{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}},
                OutlineFault::self_crossing,
                1,
                3},
       }) {
    const OutlineCheck check = check_outline(c.outline);
    EXPECT_EQ(check.fault, c.fault) << c.name;
    EXPECT_EQ(check.first, c.first) << c.name;
    EXPECT_EQ(check.second, c.second) << c.name;
  }
}

TEST(Outline, DescribesACrossingByTheNumbersOfItsSides) {
  EXPECT_EQ(describe(check_outline({{0, 0}, {1, 1}, {1, 0}, {0, 1}})),
            "sides 1 and 3 cross");
}

TEST(Outline, HasSenseAndConvexity) {
  const OutlineCheck square = check_outline({{0, 0}, {0, 1}, {1, 1}, {1, 0}});
  EXPECT_EQ(square.fault, OutlineFault::none);
  EXPECT_FALSE(square.anticlockwise);
  EXPECT_TRUE(square.convex);
  // An outline with a straight corner is convex.
  const OutlineCheck straight = check_outline({{0, 0}, {0, 1}, {0, 2}, {1, 2}, {1, 0}});
  EXPECT_EQ(straight.fault, OutlineFault::none);
  EXPECT_TRUE(straight.convex);
  const OutlineCheck dart = check_outline({{0, 0}, {3, 0}, {1, 1}, {0, 3}});
  EXPECT_EQ(dart.fault, OutlineFault::none);
  EXPECT_TRUE(dart.anticlockwise);
  EXPECT_FALSE(dart.convex);
}

TEST(Outline, CrossesItselfByOneUlp) {
  // In plain doubles the sign of this corner against the diagonal is not certain.
  const double far = 1e9;
  const double above = std::nextafter(far + 0.5, 2e9);
  const Polygon touches = {{far, far},
                           {far, far + 1},
                           {far + 1, far + 1},
                           {far + 0.5, far + 0.5},
                           {far + 1, far}};
  const Polygon misses = {{far, far},
                          {far, far + 1},
                          {far + 1, far + 1},
                          {above, far + 0.5},
                          {far + 1, far}};
  EXPECT_EQ(check_outline(touches).fault, OutlineFault::none);
  EXPECT_EQ(check_outline(misses).fault, OutlineFault::none);
  const Polygon on_side = {{0, 0}, {0, 3}, {3, 3}, {3, 2}, {0, 1}, {3, 0}};
  EXPECT_EQ(check_outline(on_side).fault, OutlineFault::self_crossing);
  const Polygon beside = {{0, 0}, {0, 3}, {3, 3}, {3, 2}, {5e-324, 1}, {3, 0}};
  EXPECT_EQ(check_outline(beside).fault, OutlineFault::none);
}

TEST(Outline, WithManyCornersReportsTheOneThatCrosses) {
  Polygon star;
  for (int i = 0; i < 4000; ++i) {
    const double angle = -2.0 * M_PI * i / 4000.0;
    const double radius = i % 2 == 0 ? 1.0 : 0.9;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  EXPECT_EQ(check_outline(star).fault, OutlineFault::none);
  EXPECT_FALSE(check_outline(star).anticlockwise);
  star[1000] = 0.95 * star[1006];  // This corner crosses three teeth.
  const OutlineCheck crossed = check_outline(star);
  EXPECT_EQ(crossed.fault, OutlineFault::self_crossing);
  EXPECT_NEAR(crossed.first, 1000, 6);
  EXPECT_NEAR(crossed.second, 1000, 6);
}

TEST(Outline, KeepsItsFirstCornerWhenReversed) {
  const Polygon p = {{0, 0}, {1, 0}, {1, 1}};
  const Polygon r = reversed(p);
  EXPECT_EQ(r[0], p[0]);
  EXPECT_EQ(r[1], p[2]);
  EXPECT_EQ(r[2], p[1]);
}

TEST(Outline, IsCopiedExactlyAndRoundedOnce) {
  // 0.1 + 3 * 0.1 is 0.4 in decimals and 0.4000000000000001 in doubles.
  const auto tenth = testing::decimal("0.1");
  const Polygon copy = place_outline({{tenth, Decimal(0)}}, {tenth, tenth}, 3);
  EXPECT_EQ(copy[0].x(), 0.4);
  EXPECT_EQ(copy[0].y(), 0.3);
}

TEST(SectionProperties, AreExactFarFromTheOrigin) {
  const double far = 1e9;
  const Polygon p = {{far, far}, {far, far + 2}, {far + 3, far + 2}, {far + 3, far}};
  const SectionProperties s = section_properties(p);
  EXPECT_DOUBLE_EQ(s.area, 6.0);
  EXPECT_EQ(s.centroid, Vec2(far + 1.5, far + 1.0));
  EXPECT_DOUBLE_EQ(s.polar_moment, 6.0 * (4.0 + 9.0) / 12.0);
}

TEST(SectionProperties, OfAnLAreTheSumsOfItsParts) {
  // An L of three unit squares has the centroid (5/6, 5/6). Its J is 3 (1/6) plus the
  // sum of the squared distances of the centroids of the squares.
  const Polygon p = {{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}};
  const SectionProperties s = section_properties(p);
  EXPECT_DOUBLE_EQ(s.area, 3.0);
  EXPECT_NEAR(s.centroid.x(), 5.0 / 6.0, 1e-15);
  EXPECT_NEAR(s.centroid.y(), 5.0 / 6.0, 1e-15);
  EXPECT_NEAR(s.polar_moment, 0.5 + 2.0 / 9.0 + 2.0 * 5.0 / 9.0, 1e-14);
}

}  // namespace
}  // namespace blocks::geometry
