// The forces of water on blocks, against integrals over the part of the block that lies
// below the table, which a clipper of this file finds.
#include "model/water.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace blocks {
namespace {

using geometry::Vec2;
using Outline = std::vector<Vec2>;

constexpr double gamma = 9810.0;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns the part of an outline where f(x) = c + n.x >= 0. Parts of a shape that is
/// not convex may be joined by seams of no area.
Outline clipped(const Outline& shape, double c, const Vec2& n) {
  Outline kept;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vec2 &a = shape[i], &b = shape[(i + 1) % shape.size()];
    const double at_a = c + n.dot(a), at_b = c + n.dot(b);
    if (at_a >= 0.0)
      kept.push_back(a);
    if ((at_a < 0.0) != (at_b < 0.0))
      kept.emplace_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

/// Area and first moments of a clockwise outline about a point.
struct Moments {
  double area = 0.0;
  Vec2 first = {0, 0};
};
Moments moments(const Outline& shape, const Vec2& about) {
  Moments sum;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vec2 a = shape[i] - about, b = shape[(i + 1) % shape.size()] - about;
    const double twice = -geometry::cross(a, b);
    sum.area += 0.5 * twice;
    sum.first += twice / 6.0 * (a + b);
  }
  return sum;
}

struct Resultant {
  Vec2 force = {0, 0};
  double moment = 0.0;
};

/// By the theorem of Gauss, the force on the part of a block below one straight part of
/// the table is minus the gradient of the pressure times its area, at its centroid.
Resultant by_areas(const Outline& shape, const WaterTable& table, const Vec2& about) {
  Resultant sum;
  const Vec2 across = table.across();
  const std::size_t n = table.place.size();
  for (std::size_t k = 0; k <= n; ++k) {
    const double left = k == 0 ? -infinity : table.place[k - 1],
                 right = k == n ? infinity : table.place[k];
    const std::size_t low = k == 0 ? 0 : k - 1, high = k == n ? n - 1 : k;
    const double slope = low == high ? 0.0
                                     : (table.to[high] - table.to[low]) /
                                           (table.place[high] - table.place[low]);
    Outline part = shape;
    if (k > 0)
      part = clipped(part, -left, across);
    if (k < n)
      part = clipped(part, right, -across);
    const Vec2 gradient = slope * across - table.up;  // of the depth
    part = clipped(part, table.to[low] - slope * table.place[low], gradient);
    const Moments its = moments(part, about);
    sum.force -= gamma * its.area * gradient;
    sum.moment -= gamma * geometry::cross(its.first, gradient);
  }
  return sum;
}

Outline star(std::mt19937& random, int corners, double min) {
  std::uniform_real_distribution<double> radius(min, 1.0), place(-3.0, 3.0),
      turn(0.0, 2.0 * std::numbers::pi);
  const Vec2 centre(place(random), place(random));
  const double begin = turn(random);
  Outline shape;
  for (int i = 0; i < corners; ++i) {
    const double angle = begin - 2.0 * std::numbers::pi * i / corners;
    shape.push_back(centre + radius(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return shape;
}

Blocks one_block(const Outline& shape, int joint = 0) {
  Blocks blocks;
  blocks.append(
      {{shape, 1, 1.0, Fixity::free, 0, std::vector<int>(shape.size(), joint)}});
  return blocks;
}

WaterTable level_at(double y) { return {gamma, {0, 1}, {0.0}, {y}, {y}}; }

TEST(Water, BuoyancyIsTheWeightOfTheWaterInPlaceOfTheBlock) {
  std::mt19937 random(1);
  for (const Vec2& shift : {Vec2(0, 0), Vec2(1e3, -2e3), Vec2(-4e5, 5.6e6)})
    for (int k = 0; k < 100; ++k) {
      Outline shape = star(random, 3 + k % 6, k % 2 == 0 ? 1.0 : 0.3);
      for (Vec2& corner : shape)
        corner += shift;
      const Blocks blocks = one_block(shape);
      const Water water{level_at(shift.y() + 10.0), {}};
      const BlockWater sum = WaterNow(water, 0.0).on_block(blocks, 0);
      const double weight = gamma * blocks.area[0];
      const double rounding = 4e-16 * (1.0 + shift.norm());
      EXPECT_EQ(sum.force.x(), 0.0);
      EXPECT_NEAR(sum.force.y() / weight, 1.0, 1e-15 + 20.0 * rounding);
      EXPECT_EQ(sum.moment, 0.0);
      EXPECT_EQ(sum.sums[1], 0.0);
    }
}

/// The sums of both ways agree: over the area, and side by side.
TEST(Water, SidesAddUpToTheBlock) {
  std::mt19937 random(2);
  const Water water{level_at(10.0), {}};
  const Water by_sides{level_at(10.0), {{.joint = 7}}};
  for (int k = 0; k < 200; ++k) {
    Outline shape = star(random, 3 + k % 6, 0.4);
    Blocks blocks = one_block(shape);
    const BlockWater area = WaterNow(water, 0.0).on_block(blocks, 0);
    BlockWater sides;
    for (int c = 0; c < blocks.corners(); ++c) {
      const EndLoads loads =
          WaterNow(by_sides, 0.0)
              .on_side(blocks.corner.col(c), blocks.corner.col(blocks.next[c]), 0);
      const Vec2 along = blocks.corner.col(blocks.next[c]) - blocks.corner.col(c);
      const Vec2 inward(along.y(), -along.x());
      for (const auto& [corner, load] :
           {std::pair{c, loads.first}, {blocks.next[c], loads.second}}) {
        const Vec2 arm = blocks.present_arm(corner), f = load * inward;
        sides.force += f;
        sides.moment += geometry::cross(arm, f);
        for (int i = 0; i < 4; ++i)
          sides.sums[i] += f[i / 2] * arm[i % 2];
      }
    }
    const double size = gamma * 10.0;
    EXPECT_LT((sides.force - area.force).norm(), 1e-13 * size);
    EXPECT_NEAR(sides.moment, area.moment, 1e-13 * size);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(sides.sums[i], area.sums[i], 1e-13 * size) << i;
  }
}

/// Any shape under any table, in any direction of gravity.
TEST(Water, AgreesWithTheAreaBelowTheTable) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(0.1, 2.0), level(-4.0, 4.0),
      turn(0.0, 2.0 * std::numbers::pi);
  int partly = 0;
  for (int k = 0; k < 2000; ++k) {
    WaterTable table;
    table.gamma = gamma;
    const double angle = k % 2 == 0 ? 0.5 * std::numbers::pi : turn(random);
    table.up = Vec2(std::cos(angle), std::sin(angle)).normalized();
    double s = -4.0;
    for (int i = 0; i < 1 + k % 5; ++i, s += step(random)) {
      table.place.push_back(s);
      table.to.push_back(level(random));
    }
    table.from = table.to;
    const Outline shape = star(random, 3 + k % 7, 0.2);
    const Blocks blocks = one_block(shape);
    const Water water{table, {}};
    const BlockWater sum = WaterNow(water, 0.0).on_block(blocks, 0);
    const Resultant wanted = by_areas(shape, table, blocks.centroid.col(0));
    // A steep table has a large gradient, and the area below it cancels.
    EXPECT_LT((sum.force - wanted.force).norm(), 1e-11 * gamma * 10.0) << k;
    EXPECT_NEAR(sum.moment, wanted.moment, 1e-11 * gamma * 10.0) << k;
    partly += wanted.force.norm() > 0.0 && sum.acts &&
              wanted.force.norm() < 0.99 * gamma * blocks.area[0];
  }
  EXPECT_GT(partly, 300);
}

/// A face between two blocks bears the same pressure from both.
TEST(Water, IsEqualAndOppositeOnBothSidesOfAFace) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  const Water water{{gamma, {0, 1}, {-3, -1, 2}, {1, 4, -2}, {1, 4, -2}}, {}};
  const WaterNow now(water, 0.0);
  for (int k = 0; k < 1000; ++k) {
    const Vec2 a(place(random), place(random)), b(place(random), place(random));
    const EndLoads one = now.on_side(a, b, 0), other = now.on_side(b, a, 0);
    const double size = gamma * 10.0;
    EXPECT_NEAR(one.first, other.second, 1e-13 * size);
    EXPECT_NEAR(one.second, other.first, 1e-13 * size);
    EXPECT_GE(one.first, 0.0);
  }
}

TEST(Water, OfAJointActsBetweenItsPointsWithinItsReach) {
  const Water water{
      level_at(100.0),
      {{.joint = 3, .a = {0, 0}, .b = {10, 0}, .p1 = 100.0, .p2 = 0.0, .reach = 0.5}}};
  const WaterNow now(water, 0.0);
  const auto force = [&](const Vec2& a, const Vec2& b, int joint = 3) {
    const EndLoads loads = now.on_side(a, b, joint);
    return (loads.first + loads.second) * (b - a).norm();
  };
  EXPECT_NEAR(force({0, 0}, {10, 0}), 500.0, 1e-12);
  EXPECT_NEAR(force({10, 0.3}, {0, 0.3}), 500.0, 1e-12);
  EXPECT_NEAR(force({-10, 0}, {20, 0}), 500.0, 1e-12) << "beyond the ends is air";
  EXPECT_NEAR(force({5, 0}, {10, 0}), 125.0, 1e-12);
  EXPECT_EQ(force({0, 0.6}, {10, 0.6}), 0.0) << "it has left the water";
  EXPECT_NEAR(force({4, 0}, {4, 10}), 60.0 * 0.5, 1e-12) << "the part within reach";
  EXPECT_GT(force({0, 0}, {10, 0}, 2), 1e6) << "other sides have the table's pressure";
  // The resultant is at a third of the length.
  const EndLoads loads = now.on_side({0, 0}, {10, 0}, 3);
  EXPECT_NEAR(loads.second / (loads.first + loads.second), 1.0 / 3.0, 1e-15);
}

TEST(Water, OfADryJointHasNoPressure) {
  const Water water{level_at(100.0), {{.joint = 3}}};
  const WaterNow now(water, 0.0);
  EXPECT_EQ(now.on_side({0, 0}, {1, 0}, 3).first, 0.0);
  EXPECT_NEAR(now.on_side({0, 0}, {1, 0}, 0).first, 50.0 * gamma, 1e-9);
}

TEST(Water, ChangesLinearlyInTime) {
  const Water water{{gamma, {0, 1}, {0, 10}, {0, 0}, {4, 8}, 2.0, 10.0},
                    {{.joint = 1,
                      .a = {0, 0},
                      .b = {1, 0},
                      .p1 = 6.0,
                      .p2 = 6.0,
                      .reach = 1.0,
                      .begin = 0.0,
                      .duration = 3.0}}};
  EXPECT_EQ(WaterNow(water, 1.0).level_at(5), 0.0);
  EXPECT_NEAR(WaterNow(water, 7.0).level_at(5), 3.0, 1e-15);
  EXPECT_EQ(WaterNow(water, 12.0).level_at(20), 8.0);
  EXPECT_TRUE(water.will_change(11.9));
  EXPECT_FALSE(water.will_change(12.0));
}

/// A side has a part for each straight part of the table that is above it.
TEST(Water, PartsOfASideEndAtThePointsOfTheTable) {
  const Water water{{gamma, {0, 1}, {0, 5, 10}, {-1, 3, -1}, {-1, 3, -1}}, {}};
  std::vector<WetPart> parts;
  WaterNow(water, 0.0).add_parts({10, 0}, {0, 0}, 0, parts);
  ASSERT_EQ(parts.size(), 2U);
  const WetPart &one = parts[0], &other = parts[1];
  // Wet from x = 1.25 to 8.75, with the largest pressure in the middle.
  EXPECT_NEAR(std::min(one.t0, other.t0), 0.125, 1e-15);
  EXPECT_NEAR(std::max(one.t1, other.t1), 0.875, 1e-15);
  EXPECT_NEAR(std::max(one.p0, one.p1), 3.0 * gamma, 1e-9);
  EXPECT_EQ(std::min(one.p0, one.p1), 0.0);
}

TEST(Water, OfAJointTakesThePlaceOfTheTableWhileItRises) {
  const Water water{level_at(1.0),
                    {{.joint = 1,
                      .a = {0, 0},
                      .b = {1, 0},
                      .p1 = 4.0,
                      .p2 = 4.0,
                      .reach = 1.0,
                      .begin = 0.0,
                      .duration = 10.0},
                     {.joint = 2, .begin = 0.0, .duration = 10.0}}};
  const auto mean = [&](int joint, double time) {
    const EndLoads loads = WaterNow(water, time).on_side({0, 0}, {1, 0}, joint);
    return loads.first + loads.second;
  };
  EXPECT_NEAR(mean(1, 0.0), gamma, 1e-9);
  EXPECT_NEAR(mean(1, 2.5), 0.75 * gamma + 1.0, 1e-9);
  EXPECT_NEAR(mean(1, 10.0), 4.0, 1e-12);
  EXPECT_NEAR(mean(2, 5.0), 0.5 * gamma, 1e-9) << "it dries";
  EXPECT_EQ(mean(2, 10.0), 0.0);
}

TEST(Water, ThatDrainsIsGoneAfterwards) {
  WaterTable table = level_at(5.0);
  table.to = {-9.0};
  table.duration = 2.0, table.drains = true;
  const Water water{table, {}};
  EXPECT_TRUE(WaterNow(water, 1.9).has_table());
  EXPECT_FALSE(WaterNow(water, 2.0).has_table());
  EXPECT_EQ(WaterNow(water, 3.0).on_side({0, -20}, {1, -20}, 0).first, 0.0);
}

}  // namespace
}  // namespace blocks
