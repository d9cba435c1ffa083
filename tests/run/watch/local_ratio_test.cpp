// SOLVE tests the local ratio of each block beside the ratio of the whole model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "deck/commands.hpp"
#include "post/read/results_reader.hpp"
#include "run/support/progress_line.hpp"
#include "run/watch/convergence.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string cards = "GRAVITY, 0, -9.81\nFRICTN, 0.5\nLOCDAMP, .8\n";
const std::string on_floor = preliminary() + rectangle(-5, -1, 5, 0, true);

/// Block 2 rests on the floor; block 3 is 1000 times lighter and falls far from it.
const std::string pebble =
    on_floor + rectangle(-4, 0, 1, 2) + rectangle(7, 0, 7.1, 0.1) + cards;
/// The same with equal blocks, whose steps are at multiples of 0.0004.
const std::string bricks =
    on_floor + rectangle(-4, 0, -3, 1) + rectangle(7, 0, 8, 1) + cards;

TEST(LocalRatio, IsAHundredTimesTheRatioUnlessGiven) {
  deck::Solve card{{1e-5, {}}, {100, {}}};
  EXPECT_DOUBLE_EQ(card.local_ratio(), 1e-3);
  card.ratio.value = 0.5;
  EXPECT_EQ(card.local_ratio(), 0.01);
  card.local = {0.3, {}, true};
  EXPECT_EQ(card.local_ratio(), 0.3);
}

TEST(LocalRatio, KeepsSolveFromEndingWhileOneBlockFalls) {
  const TemporaryFolder folder;
  const Outcome run = run_text(folder, "a", pebble + "SOLVE, 3.E-3, 20000\nSTOP\n");
  const auto solve = summary(folder, "a")["solves"][0];
  EXPECT_LE(solve["reached"], 3e-3);
  EXPECT_FALSE(solve["converged"]);
  EXPECT_EQ(solve["local"], 0.01);
  EXPECT_NEAR(solve["reached_local"], 1.0, 1e-9);
  EXPECT_EQ(solve["local_block"], 3);
  EXPECT_THAT(run.err, HasSubstr("the largest local ratio, 1, wanted 0.01, is that of "
                                 "block 3 (blocks plot --colour local_ratio)"));
  EXPECT_THAT(slurp(folder / "a.out"), HasSubstr("largest local ratio"));
}

TEST(LocalRatio, GivesWayIfTheCardSaysSo) {
  const TemporaryFolder folder;
  const Outcome run = run_text(folder, "a", pebble + "SOLVE, 3.E-3, 8000, 10.\nSTOP\n");
  EXPECT_TRUE(summary(folder, "a")["converged"]);
  EXPECT_THAT(run.err, HasSubstr("local ratio 1 (block 3) after"));
  EXPECT_THAT(run.err, Not(HasSubstr("warning: SOLVE")));
}

TEST(LocalRatio, IsInFramesAndHistories) {
  const TemporaryFolder folder;
  run_text(folder, "a",
           bricks + "PLOTS, 0.02\nHISTORY, 0.02, UNBALANCED:LOCAL, local_ratio:2, "
                    "local_ratio:3\nCYCLE, 120\nSTOP\n");
  const post::ResultsReader results((folder / "a.vtkhdf").string());
  const post::RecordedHistory recorded = results.recorded().at(0);
  EXPECT_EQ(recorded.quantities[0], "unbalanced:local");
  for (int k = 1; k < 3; ++k) {
    const post::Frame frame = results.frame(k);
    EXPECT_EQ(frame.local_ratio[0], 0.0);  // fixed
    EXPECT_NEAR(frame.local_ratio[2], 1.0, 1e-9);
    EXPECT_NEAR(recorded.values(0, k), 1.0, 1e-9);
    EXPECT_NEAR(recorded.values(1, k), frame.local_ratio[1], 1e-9);
    EXPECT_NEAR(recorded.values(2, k), 1.0, 1e-9);
  }
  EXPECT_THAT(blocks("history a.vtkhdf -q unbalanced:local", folder.path()).out,
              HasSubstr("unbalanced:local"));
  ASSERT_EQ(blocks("plot a.vtkhdf --colour local_ratio -o a.svg", folder.path()).code,
            0);
  EXPECT_THAT(slurp(folder / "a.svg"), HasSubstr("largest local ratio 1 in block 3"));
}

TEST(ProgressLine, NamesTheWorstBlockDuringSolve) {
  run::RunProgress at{0.5, 60.0, 1000, 0.5, {}};
  at.balance = {3.21e-4, 0.98, 16};
  EXPECT_THAT(run::log_line(at),
              HasSubstr("ratio 3.2e-04, local ratio 9.8e-01 block 17, step 1000"));
  EXPECT_THAT(run::progress_line(at, 100),
              HasSubstr(" ratio 3.2e-04 local ratio 9.8e-01 block 17 "));
}

}  // namespace
}  // namespace blocks::testing
