// UncoveredSide, the test in plain doubles, never contradicts the oracle.
#include "geometry/covered_side.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "covered_side_oracle.hpp"

namespace blocks::geometry {
namespace {

using namespace covering_tests;

/// Whether UncoveredSide is sure that nothing covers the side.
bool is_surely_uncovered(const Scene& s, double room) {
  UncoveredSide side({s.own, s.side, s.at_start}, s.other, room, room);
  for (const Polygon& neighbour : s.neighbours)
    side.add(neighbour);
  return side.is_sure();
}

// A disc turned by almost ten degrees overlaps the side deeply. It is deeper below that
// side than below another side of `own`. Its own side is less deep, so the two touch
// along these sides and the disc covers.
TEST(UncoveredSide, MeasuresOverlapBelowTheCoveringSide) {
  Scene s;
  s.own = {{-0.238115, -0.039847}, {0, 0}, {5, 0}, {5, -5}, {-5, -5}};
  s.side = 1;
  s.at_start = true;
  s.other = {{-0.01, -1.2}, {-0.01, 0.1}, {0.02, 0.1}, {0.02, -1.2}};
  // The first side of the disc is a little nearer to the centre than the others.
  const auto normal = [](int k) {
    const double angle = (-80.1 - 10.0 * k) * std::numbers::pi / 180.0;
    return Vec2(std::cos(angle), std::sin(angle));
  };
  const auto distance = [](int k) { return k % 36 == 0 ? 1.0 : 1.00001; };
  Polygon disc;
  for (int k = 0; k < 36; ++k) {
    Eigen::Matrix2d normals;
    normals << normal(k + 35).transpose(), normal(k).transpose();
    disc.push_back(s.own[0] + normals.inverse() * Vec2(distance(k + 35), distance(k)));
  }
  s.neighbours = {disc};
  EXPECT_TRUE(covering_of(s));
  EXPECT_FALSE(is_surely_uncovered(s, 0.0));
}

/// Bricks that are nearly flush with the side and tilted a little, and a block near the
/// joint. Some neighbours are much smaller or larger than the side, and some graze it.
Scene nearly_flush(Random& random) {
  Scene s;
  const double length = random.uniform(0.5, 3), height = random.uniform(0.5, 3);
  s.own = {{0, 0}, {length, 0}, {length, -height}, {0, -height}};
  s.at_start = random.coin();
  const double joint = s.at_start ? 0 : length, into = s.at_start ? 1 : -1;
  double x = joint - into * random.uniform(0, 0.5);
  for (int n = random.whole(1, 4); n > 0; --n) {
    const double width = std::pow(10.0, random.uniform(-2, 1));
    const double gap = std::pow(10.0, random.uniform(-14, -0.5)) * random.whole(-1, 1);
    const double tilt = std::pow(10.0, random.uniform(-14, -0.7)) * random.whole(-1, 1);
    const double next = x + into * width, top = gap + random.uniform(0.3, 4);
    const double low = std::min(x, next), high = std::max(x, next);
    s.neighbours.push_back({{low, gap},
                            {low, top},
                            {high, top + tilt * width},
                            {high, gap + tilt * width}});
    x = next + random.whole(-1, 1) * std::pow(10.0, random.uniform(-14, -1));
  }
  const double deep = std::pow(10.0, random.uniform(-9, 0.3));
  const double size = std::pow(10.0, random.uniform(-1, 0.7));
  const double beyond = joint + into * deep, top = random.uniform(-0.5, 1) * size;
  const double low = std::min(beyond, beyond - into * size),
               high = std::max(beyond, beyond - into * size);
  s.other = box(low, top - size, high, top);
  s.other[static_cast<std::size_t>(random.whole(0, 3))].x() +=
      random.uniform(-0.1, 0.1) * size;
  return s;
}

/// Moves each corner at random by up to half the room.
Scene moved(Random& random, Scene s, double room) {
  s.transform([&](const Vec2& v) -> Vec2 {
    const double angle = random.uniform(0, 6.3);
    const double by = 0.5 * room * (random.coin() ? 1.0 : random.uniform(0, 1));
    return v + (1 - 1e-9) * by * Vec2(std::cos(angle), std::sin(angle));
  });
  return s;
}

// UncoveredSide must be right for every motion within the room, and must be sure in
// most scenes where the side is uncovered.
TEST(UncoveredSide, HoldsAfterAnyMotionWithinTheRoom) {
  Random random;
  const int scenes = std::getenv("BLOCKS_THOROUGH") != nullptr ? 1'000'000 : 12'000;
  int uncovered = 0, sure = 0, uncovered_with_room = 0, sure_with_room = 0;
  for (int n = 0; n < scenes; ++n) {
    Scene s = n % 3 == 0   ? bricks(random)
              : n % 3 == 1 ? random_scene(random)
                           : nearly_flush(random);
    if (random.coin())
      s = mirrored(s);
    const double angle = random.whole(0, 3) ? random.uniform(0, 6.3) : 0.0;
    turn(s, std::cos(angle), std::sin(angle),
         random.vector(random.coin() ? std::pow(10.0, random.whole(0, 9)) : 0.0));
    if (!s.is_proper())
      continue;
    const bool is_uncovered = !Oracle(s).answer();
    const bool is_sure = is_surely_uncovered(s, 0.0);
    uncovered += is_uncovered, sure += is_sure;
    ASSERT_TRUE(is_uncovered || !is_sure) << n << "\n" << text(s);
    const double room = std::pow(10.0, random.uniform(-12, -0.5));
    if (!is_surely_uncovered(s, room)) {
      uncovered_with_room += is_uncovered && room < 0.01;
      continue;
    }
    ASSERT_TRUE(is_sure) << n << "\n" << text(s);
    uncovered_with_room += room < 0.01, sure_with_room += room < 0.01;
    for (int k = 0; k < 3; ++k) {
      const Scene after = moved(random, s, room);
      ASSERT_TRUE(!after.is_proper() || !Oracle(after).answer())
          << n << ", room " << room << "\n"
          << text(s) << "\nmoved: " << text(after);
    }
  }
  RecordProperty("uncovered", uncovered);
  RecordProperty("sure", sure);
  RecordProperty("uncovered_with_room", uncovered_with_room);
  RecordProperty("sure_with_room", sure_with_room);
  EXPECT_GT(uncovered, scenes / 2);
  EXPECT_GT(scenes - uncovered, scenes / 8);
  EXPECT_GT(sure, 0.85 * uncovered) << "of " << uncovered;
  EXPECT_GT(sure_with_room, 0.8 * uncovered_with_room) << "of " << uncovered_with_room;
}

// A side that is shorter than the room can turn by any angle.
TEST(UncoveredSide, IsNotSureOfSidesShorterThanTheRoom) {
  // Two slivers are side by side, and a box is on both of them.
  const Polygon own = box(0, 0, 1, 0.1), beside = box(1, 0, 2, 0.1),
                other = box(0.5, 0.05, 1.5, 1);
  for (const double room : {0.0, 0.04, 0.051, 0.1, 1.0}) {
    UncoveredSide side({own, 2, true}, other, room, room);
    side.add(beside);
    EXPECT_FALSE(side.is_sure()) << room;
  }
}

TEST(UncoveredSide, AgreesWithTheOracleForAnyMagnitude) {
  Random random;
  int sure = 0;
  for (int n = 0; n < 3000; ++n) {
    Scene s = n % 3 == 0   ? bricks(random)
              : n % 3 == 1 ? random_scene(random)
                           : nearly_flush(random);
    const int most = n % 8 < 4 ? 440 : 1020;
    const double size = std::ldexp(1, random.whole(-most, most));
    s.transform([&](const Vec2& v) -> Vec2 { return size * v; });
    if (n % 4 == 3)
      s.transform([&](const Vec2& v) -> Vec2 {
        return v * std::ldexp(1, random.whole(-most, most));
      });
    if (!s.is_proper() || !is_surely_uncovered(s, 0.0))
      continue;
    ++sure;
    ASSERT_FALSE(Oracle(s).answer()) << n << "\n" << text(s);
  }
  EXPECT_GT(sure, 500);
}

}  // namespace
}  // namespace blocks::geometry
