// Histories of several results files: the parts of one run are joined, and many runs
// become a band.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "post/chart/run_band.hpp"
#include "post/read/run_parts.hpp"
#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string fall = preliminary() + rectangle(0, 0, 1, 1) +
                         "GRAVITY, 0, -10\nSETVEL, 1, 0, 1\nPLOTS, 0.004\n";

class Parts : public ::testing::Test {
 protected:
  void SetUp() override {
    run_text(folder_, "whole", fall + "CYCLE, 100\nCYCLE, 60\n");
    run_text(folder_, "begin", fall + "CYCLE, 100\n");
    run_text(folder_, "end", "RESTART, begin.ckpt.h5\nCYCLE, 60\n");
  }
  std::string csv(const std::string& files) {
    const Outcome run =
        blocks("history " + files + " -q dy:1,vy:1 --csv", folder_.path());
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  }
  /// Returns the lines of a table without those at time 0.04, where only runs in parts
  /// have a frame.
  static std::string without_seam(const std::string& table) {
    std::istringstream lines(table);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with("0.04,"))
        kept += line + '\n';
    return kept;
  }
  TemporaryFolder folder_;
};

TEST_F(Parts, OfOneRunAreOneCurve) {
  const std::string joined = csv("begin.vtkhdf end.vtkhdf");
  EXPECT_EQ(without_seam(joined), without_seam(csv("whole.vtkhdf")));
  EXPECT_EQ(csv("end.vtkhdf begin.vtkhdf"), joined);
  EXPECT_THAT(joined, HasSubstr("\n0.04,"));
  EXPECT_EQ(joined.find("\n0.04,"), joined.rfind("\n0.04,")) << "the seam is one point";
}

TEST_F(Parts, OfARunResumedUnderAnotherNameAreJoined) {
  ASSERT_EQ(blocks("run whole.deck -o stopped --stop-after 30", folder_.path()).code,
            75);
  ASSERT_EQ(
      blocks("run whole.deck --restart stopped.ckpt.h5 -o rest", folder_.path()).code,
      0);
  EXPECT_THAT(csv("stopped.vtkhdf rest.vtkhdf"), StartsWith("time,"));
}

TEST_F(Parts, OfDifferentRunsStaySeparate) {
  EXPECT_THAT(csv("whole.vtkhdf begin.vtkhdf"), StartsWith("run,time,"));
  EXPECT_THAT(csv("whole.vtkhdf end.vtkhdf"), StartsWith("run,time,"));
}

// Both continuations have the same beginning.
TEST_F(Parts, MayBelongToSeveralRuns) {
  run_text(folder_, "other", "RESTART, begin.ckpt.h5\nSETVEL, 1, 0, 9\nCYCLE, 60\n");
  const auto path = [&](const std::string& name) {
    return (folder_ / (name + ".vtkhdf")).string();
  };
  const auto runs = post::join_parts({path("end"), path("other"), path("begin")});
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_THAT(runs[0].files, ElementsAre(path("begin"), path("end")));
  EXPECT_THAT(runs[1].files, ElementsAre(path("begin"), path("other")));
}

// The continuation begins before the end of the first results.
TEST_F(Parts, ThatGoOnAreAlsoRunsOfTheirOwn) {
  ASSERT_EQ(
      blocks("run begin.deck --restart begin.ckpt.h5 --until 0.05", folder_.path())
          .code,
      0);
  const auto runs = post::join_parts(
      {(folder_ / "begin.vtkhdf").string(), (folder_ / "end.vtkhdf").string()});
  EXPECT_EQ(runs.size(), 2U);
}

TEST_F(Parts, AreNamedInResultsOfContinuedRunsOnly) {
  EXPECT_FALSE(stored(folder_ / "begin.vtkhdf").contains("BLOCKS/continues_run"));
  EXPECT_EQ(stored(folder_ / "end.vtkhdf").at("BLOCKS/continues_run"),
            stored(folder_ / "begin.vtkhdf").at("BLOCKS/run_id"));
}

// Displacements that each part recorded have different origins.
TEST_F(Parts, DoNotMixRecordedDisplacements) {
  run_text(folder_, "one", fall + "HISTORY, 0.01, y:1, dy:1\nCYCLE, 100\n");
  run_text(folder_, "two", "RESTART, one.ckpt.h5\nCYCLE, 60\n");
  const Outcome moved =
      blocks("history one.vtkhdf two.vtkhdf -q dy:1 --csv", folder_.path());
  EXPECT_EQ(moved.code, 0);
  EXPECT_THAT(moved.err, HasSubstr("are those of its frames: recorded displacements"));
  EXPECT_EQ(blocks("history one.vtkhdf two.vtkhdf -q y:1 --csv", folder_.path()).err,
            "");
}

// The last part has no outline of a block that is removed there.
TEST_F(Parts, KnowTheCornersOfABlockThatIsRemovedLater) {
  run_text(folder_, "gone",
           "RESTART, begin.ckpt.h5\nREMOVE, 1\nCREATE, 4, 1, 1\n0, 0, 1, 1\n0, 1, 1, "
           "0\nCYCLE, 10\n");
  const Outcome corner =
      blocks("history begin.vtkhdf gone.vtkhdf -q y:1.2 --csv", folder_.path());
  EXPECT_EQ(corner.code, 0) << corner.err;
  EXPECT_EQ(blocks("history begin.vtkhdf gone.vtkhdf -q y:1.5", folder_.path()).err,
            "blocks: error: gone.vtkhdf: block 1 has corners 1 to 4, no corner 5\n");
}

// The time 0.06 lies in the second part.
TEST_F(Parts, HaveProfilesAtTheTimesOfAllParts) {
  const Outcome run =
      blocks("history begin.vtkhdf end.vtkhdf --profile top -t 0.02,0.06 --csv",
             folder_.path());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("position,block,dy@0.02,dy@0.06"));
}

TEST(Band, HasThePercentilesOfTheRuns) {
  std::vector<draw::ChartLine> lines;
  for (int i = 0; i <= 20; ++i)  // parallel lines
    lines.push_back({"", {0, 2}, {1.0 * i, i + 2.0}});
  lines[3] = {"", {-1, 0, 1, 2, 3}, {2, 3, 4, 5, 6}};  // the same line, more points
  const draw::ChartLine band = post::band_of(lines);
  EXPECT_THAT(band.x, ElementsAre(0, 1, 2));
  EXPECT_THAT(band.low, ElementsAre(1, 2, 3));
  EXPECT_THAT(band.y, ElementsAre(10, 11, 12));
  EXPECT_THAT(band.high, ElementsAre(19, 20, 21));
}

TEST(Band, NeedsACommonRange) {
  EXPECT_THROW(post::band_of({{"", {0, 1}, {0, 0}}, {"", {2, 3}, {0, 0}}}),
               std::runtime_error);
}

class ManyRuns : public ::testing::Test {
 protected:
  /// Runs a random layer with the seeds 1 to `count`, and returns the figure.
  std::string figure(int count, const std::string& more = {}) {
    std::string files;
    folder_.write("layer.deck",
                  preliminary() + rectangle(-5, -1, 5, 0, true) +
                      "ORIENT, -10, 10\nLAYER, -4, 1, -4,0, -4,1, 4,1, 4,0, RANDOM\n"
                      "GRAVITY, 0, -10\nPLOTS, 0.002\nMOTION, 0.01\n");
    for (int i = 1; i <= count; ++i) {
      const std::string name = "run" + std::to_string(i);
      const Outcome run =
          blocks("run layer.deck -q --seed " + std::to_string(i) + " -o " + name,
                 folder_.path());
      EXPECT_EQ(run.code, 0) << run.err;
      files += name + ".vtkhdf ";
    }
    const Outcome drawn =
        blocks("history " + files + more + " -o a.svg", folder_.path());
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    return slurp(folder_ / "a.svg");
  }
  TemporaryFolder folder_;
};

TEST_F(ManyRuns, AreABandWithAMedian) {
  const std::string band = figure(9, "-q speed:max");
  EXPECT_THAT(band, HasSubstr("largest speed, median"));
  EXPECT_THAT(band, HasSubstr("5 to 95 % of 9 runs"));
  EXPECT_THAT(band, Not(HasSubstr("run3")));
  EXPECT_THAT(figure(9, "-q speed:max --each-run"),
              HasSubstr("largest speed, run3 (seed 3)"));
  EXPECT_THAT(figure(9, "--profile top -t 0.01"), HasSubstr("t = 0.01, median"));
}

TEST_F(ManyRuns, AreCurvesWithTheirSeedsIfTheyAreFew) {
  EXPECT_THAT(figure(8, "-q speed:max"), HasSubstr("largest speed, run3 (seed 3)"));
}

TEST(Profile, SaysThatItTookTheNearestFrame) {
  const TemporaryFolder folder;
  run_text(folder, "fall", fall + "CYCLE, 100\n");
  const auto legend = [&](const std::string& time) {
    EXPECT_EQ(
        blocks("history fall.vtkhdf --profile top -o a.svg -t " + time, folder.path())
            .code,
        0);
    return slurp(folder / "a.svg");
  };
  EXPECT_THAT(legend("0.021"), HasSubstr("t = 0.02, nearest to 0.021"));
  EXPECT_THAT(legend("0.02"), Not(HasSubstr("nearest")));
}

}  // namespace
}  // namespace blocks::testing
