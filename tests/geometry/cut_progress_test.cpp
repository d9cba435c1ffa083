// Progress during cutting and generating, and interruption by an exception. The run of
// the tests under the address sanitizer shows that nothing leaks.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/geometry/cut_scenes.hpp"

namespace blocks::geometry {
namespace {

using testing::number;
using testing::points;
using testing::ten;

struct Interrupted {
  std::string step;
};

std::vector<JointSegment> many_joints() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(0.0, 10.0);
  std::vector<JointSegment> joints;
  for (int i = 0; i < 300; ++i)
    joints.push_back(
        {Vec2(part(random), part(random)), Vec2(part(random), part(random)), 1});
  // Joints that overlap, because the sweep keeps them apart from the others.
  for (int i = 0; i < 30; ++i)
    joints.push_back({Vec2(1.0 + 0.1 * i, 5.0), Vec2(8.0 + 0.05 * i, 5.0), 2});
  return joints;
}

// Runs `work` once to the end and then, for many k, with a function that throws at call
// k. Returns the steps that were interrupted.
std::set<std::string>
interrupt(const std::function<void(const ProgressFunction&)>& work) {
  int calls = 0;
  double last = 0.0;
  work([&](const std::string&, double part) {
    ++calls;
    EXPECT_GE(part, last);
    EXPECT_LE(part, 1.0);
    last = part;
  });
  std::set<std::string> steps;
  for (int k = 1; k <= calls; k += std::clamp(calls - 4 - k, 1, 1 + calls / 25)) {
    int left = k;
    try {
      work([&](const std::string& step, double) {
        if (--left == 0)
          throw Interrupted{step};
      });
      ADD_FAILURE() << "call " << k << " of " << calls << " did not stop the work";
    } catch (const Interrupted& stop) {
      steps.insert(stop.step);
    }
  }
  return steps;
}

TEST(CutProgress, ExceptionStopsTheCuttingInEachStep) {
  CutRequest cuts = testing::request(ten, many_joints());
  cuts.emin = 0.02;
  cuts.amin = 0.002;
  int during_arrangement = 0;
  const auto steps = interrupt([&](const ProgressFunction& progress) {
    cuts.progress = [&](const std::string& step, double part) {
      during_arrangement +=
          step == "arrange joints" && part > 0.1 && part < 0.4 ? 1 : 0;
      progress(step, part);
    };
    cut_outline(cuts);
  });
  EXPECT_GT(during_arrangement, 10);
  EXPECT_TRUE(steps.contains("arrange joints"));
  EXPECT_TRUE(steps.contains("certify cells"));
}

TEST(CutProgress, ExceptionStopsTheGenerators) {
  const auto outline = points(ten);
  JointSet set;
  set.dip.mean = number("30");
  set.spacing.mean = number("0.05");
  set.trace.mean = number("0.3");
  set.gap.mean = number("0.1");
  EXPECT_FALSE(interrupt([&](const ProgressFunction& progress) {
                 joint_set(set, outline, progress);
               }).empty());
  VoronoiRequest cells;
  cells.count = 3000;
  cells.lloyd = 1;
  EXPECT_EQ(interrupt([&](const ProgressFunction& progress) {
              voronoi_cells(cells, outline, progress);
            }),
            (std::set<std::string>{"draw points", "make cells", "relax points"}));
  EXPECT_FALSE(interrupt([&](const ProgressFunction& progress) {
                 prolonged(many_joints(), number("1"), {}, outline, progress);
               }).empty());
}

}  // namespace
}  // namespace blocks::geometry
