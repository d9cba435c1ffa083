// The work grows little faster than the number of joints. It is counted in reports of
// progress, one for each 1024 steps of the inner loops, and so without a clock.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "tests/geometry/cut_scenes.hpp"

namespace blocks::geometry {
namespace {

using testing::number;
using testing::points;
using testing::ten;

double reports(const std::function<void(const ProgressFunction&)>& work) {
  double count = 0.0;
  work([&count](const std::string&, double) { ++count; });
  return count;
}

// Four times as many joints take at most six times the work: n log n is below five, and
// n^2 would be sixteen.
void expect_little_more(const std::function<double(int count)>& work, int count) {
  const double some = work(count), more = work(4 * count);
  EXPECT_GT(some, 20.0);  // otherwise the counts would say little
  EXPECT_LT(more, 6.0 * some);
}

// Traces in a square of side 10, three mean distances long. directions: of all angles,
// as a part of 180 degrees.
std::vector<JointSegment> traces(int count, double directions = 1.0) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::vector<JointSegment> result;
  const double half = 15.0 / std::sqrt(count);
  for (int i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * (0.2 + directions * part(random));
    const Vec2 d(half * std::cos(angle), half * std::sin(angle));
    const double x = 10.0 * part(random);
    const Vec2 p(x, 10.0 * part(random));
    result.push_back({Vec2(p - d), Vec2(p + d), 1});
  }
  return result;
}

TEST(CutScaling, CuttingIsNearlyLinear) {
  expect_little_more(
      [](int count) {
        CutRequest cuts = testing::request(ten, traces(count));
        return reports([&](const ProgressFunction& progress) {
          cuts.progress = progress;
          cut_outline(cuts);
        });
      },
      2500);
}

// Snap may be as large as the domain.
TEST(CutScaling, ProlongingIsNearlyLinear) {
  for (const double directions : {1.0, 0.1})
    expect_little_more(
        [&](int count) {
          return reports([&](const ProgressFunction& progress) {
            prolonged(traces(count, directions), number("20"), {}, points(ten),
                      progress);
          });
        },
        1500);
}

// Each of the beds crosses the box of most traces, but not the traces.
TEST(CutScaling, EndingIsNearlyLinear) {
  expect_little_more(
      [](int count) {
        std::vector<JointSegment> beds;
        const int layers = static_cast<int>(std::sqrt(count));
        for (int i = -layers; i < 2 * layers; ++i) {
          const double y = 10.0 * i / layers;
          beds.push_back({Vec2(-1.0, y), Vec2(11.0, y + 9.0), 1});
        }
        return reports([&](const ProgressFunction& progress) {
          ended_at(traces(count), beds, progress);
        });
      },
      2500);
}

// Most pairs of short traces are far apart, so few random pairs would cross.
TEST(LikelyCrossings, OfManyShortTracesAreFound) {
  constexpr int count = 200'000;
  // Each trace of length l crosses 2 l^2 n / (pi A) others, if the border is far.
  const double expected = 0.5 * count * 2.0 * 9.0 / std::numbers::pi;
  const double found =
      likely_crossings(traces(count), Vec2(0.0, 0.0), Vec2(10.0, 10.0));
  EXPECT_NEAR(found, expected, 0.25 * expected);
  EXPECT_EQ(found, likely_crossings(traces(count), Vec2(0.0, 0.0), Vec2(10.0, 10.0)));
}

TEST(LikelyCrossings, OfFewTracesAreCounted) {
  const auto joints = testing::joints("0 1 10 1 0 4 10 4 2 0 2 10 5 0 5 3 9 2 9 12");
  EXPECT_EQ(likely_crossings(joints, Vec2(0.0, 0.0), Vec2(10.0, 10.0)), 4.0);
  EXPECT_EQ(likely_crossings({}, Vec2(0.0, 0.0), Vec2(10.0, 10.0)), 0.0);
}

}  // namespace
}  // namespace blocks::geometry
