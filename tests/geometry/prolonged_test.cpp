// Prolonged traces: which ends move, and where to.
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/joint_sources.hpp"
#include "tests/geometry/cut_scenes.hpp"

namespace blocks::geometry {
namespace {

using testing::joints;
using testing::number;
using testing::points;
using testing::request;
using testing::ten;

TEST(Prolonged, EndsThatTouchAJointOrAreOutsideDoNotMove) {
  const auto traces = joints("1 5 5 5 5 1 5 9 9.5 2 12 2 2 2 5 2");
  const Prolongation result = prolonged(traces, Decimal(2), {}, points(ten));
  // 1 5: to the left side. 5 1 and 5 9: to the lower and upper side. 2 2: to the left
  // side. 9.5 2 -> 12 2 begins inside and dangles; the next joint is 4.5 away.
  EXPECT_EQ(result.ends, 4U);
  EXPECT_EQ(result.loose, 5U);
  EXPECT_EQ(result.largest, 2.0);
  EXPECT_EQ(result.place, Vec2(2, 2));
  EXPECT_EQ(result.traces[0].from.nearest(), Vec2(0, 5));
  EXPECT_EQ(result.traces[0].to.nearest(), Vec2(5, 5));
  EXPECT_EQ(result.traces[1].from.nearest(), Vec2(5, 0));
  EXPECT_EQ(result.traces[1].to.nearest(), Vec2(5, 10));
  EXPECT_EQ(result.traces[2].from.nearest(), Vec2(9.5, 2));
  EXPECT_EQ(result.traces[3].from.nearest(), Vec2(0, 2));
}

// The prolonged end is on the other joint exactly, whatever the direction.
TEST(Prolonged, ReachesTheOtherJointExactly) {
  auto traces = joints("0.1 0 9.7 10 1.3 7.1 2.9 3.7 0.9 9.1 4.1 6.3");
  const Prolongation result = prolonged(traces, Decimal(20), {}, points(ten));
  CutRequest cuts = request(ten, result.traces);
  const CutResult cut = cut_outline(cuts);
  EXPECT_EQ(cut.mesh.cells.size(), 4U);
  EXPECT_NEAR(cut.report.p21_before - cut.report.p21_after, 0.0, 1e-12);
  testing::expect_tiling(cut);
}

// Squares of such lengths are not doubles.
TEST(Prolonged, TracesMayBeTinyOrEndFarAway) {
  const auto traces = joints("5 5 5 5.00000000000000000000000000001 -1e300 2 0 2 "
                             "1e-200 1e-200 2e-200 2e-200 2 3 3 3");
  const Prolongation result = prolonged(traces, Decimal(20), {}, points(ten));
  EXPECT_EQ(result.traces[0].from.nearest(), Vec2(5, 0));
  EXPECT_EQ(result.traces[0].to.nearest(), Vec2(5, 10));
  EXPECT_EQ(result.traces[2].from.nearest(), Vec2(0, 0));
  EXPECT_EQ(result.traces[2].to.nearest(), Vec2(3, 3));
  testing::expect_tiling(cut_outline(request(ten, result.traces)));
}

// Two corners of the same kind, open by 0.1 and by 0.3.
TEST(Prolonged, TwoLooseEndsMeetInACorner) {
  const auto traces = joints("2 0 2 2.9 2.1 3 10 3 6 0 6 4.7 6.3 5 10 5");
  const Prolongation result = prolonged(traces, number("0.2"), {}, points(ten));
  EXPECT_EQ(result.ends, 2U);
  EXPECT_EQ(result.loose, 4U);
  EXPECT_EQ(result.traces[0].to.nearest(), Vec2(2, 3));
  EXPECT_EQ(result.traces[1].from.nearest(), Vec2(2, 3));
  EXPECT_EQ(result.traces[2].to.nearest(), Vec2(6, 4.7));
  const CutResult cut = cut_outline(request(ten, result.traces));
  EXPECT_EQ(cut.mesh.cells.size(), 3U);
  testing::expect_tiling(cut);
}

// The point is as far as snap from one end, and a little farther from the other one.
TEST(Prolonged, ACornerMustBeWithinReachOfBothEnds) {
  const auto traces = joints("2 0 2 2.9 2.2 3 10 3");
  EXPECT_EQ(prolonged(traces, number("0.2"), {}, points(ten)).ends, 2U);
  EXPECT_EQ(prolonged(traces, number("0.19999"), {}, points(ten)).ends, 0U);
}

// An end that reaches a joint is prolonged to it, also if it passes the corner.
TEST(Prolonged, JointsComeBeforeCorners) {
  const auto traces = joints("2 0 2 2.5 2.5 3 10 3");
  EXPECT_EQ(prolonged(traces, Decimal(1), {}, points(ten)).traces[0].to.nearest(),
            Vec2(2, 3));
  const auto through_gap = joints("1 4.25 4 1.25");  // x + y = 5.25
  const Prolongation result = prolonged(traces, Decimal(1), through_gap, points(ten));
  // (2, 3.25) is behind the corner, and (2.25, 3) before it.
  EXPECT_EQ(result.traces[0].to.nearest(), Vec2(2, 3.25));
  EXPECT_EQ(result.traces[1].from.nearest(), Vec2(2.25, 3));
}

// The third trace meets the prolongation of the first one, behind the corner.
TEST(Prolonged, CornersDoNotDependOnTheOrderOfTheTraces) {
  const std::vector<std::string> given = {"2 0 2 2.9", "2.1 3 10 3", "0 3.5 1.5 3.2"};
  std::vector<std::size_t> order = {0, 1, 2};
  do {
    const Prolongation result = prolonged(
        joints(given[order[0]] + " " + given[order[1]] + " " + given[order[2]]),
        number("0.5"), {}, points(ten));
    EXPECT_EQ(result.ends, 2U);
    for (std::size_t k = 0; k < 3; ++k) {
      const JointSegment& trace = result.traces[k];
      if (order[k] == 0) {
        EXPECT_EQ(trace.to.nearest(), Vec2(2, 3));
      } else if (order[k] == 1) {
        EXPECT_EQ(trace.from.nearest(), Vec2(2, 3));
      } else {
        EXPECT_EQ(trace.to.nearest(), Vec2(1.5, 3.2));
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

// Prolongations of the first three traces meet in (5, 5), but the third one meets the
// fourth before, and the fourth reaches no other one.
TEST(Prolonged, ACornerIsNotLostToAnEndThatMeetsAnotherOneBefore) {
  std::vector<std::string> given = {"0 0 4.7 4.7", "0 9.8 4.6 5.2", "10 5 5.3 5",
                                    "5 0 5 4.7"};
  std::sort(given.begin(), given.end());
  do {
    std::string text;
    for (const std::string& trace : given)
      text += trace + " ";
    EXPECT_EQ(prolonged(joints(text), number("0.43"), {}, points(ten)).ends, 4U)
        << text;
  } while (std::next_permutation(given.begin(), given.end()));
}

// Three prolongations through one point, whatever the directions.
TEST(Prolonged, ThreeLooseEndsMeetInOnePoint) {
  const auto traces = joints("5 0 5 4.7 10 5 5.3 5 0 0 4.7 4.7");
  const Prolongation result = prolonged(traces, number("0.5"), {}, points(ten));
  EXPECT_EQ(result.ends, 3U);
  const CutResult cut = cut_outline(request(ten, result.traces));
  EXPECT_EQ(cut.mesh.cells.size(), 3U);
  testing::expect_tiling(cut);
}

}  // namespace
}  // namespace blocks::geometry
