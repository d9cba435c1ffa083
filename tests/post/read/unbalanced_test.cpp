// Unbalanced forces in results, histories, figures and pages, and their absence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "post/page/view_data.hpp"
#include "post/read/frame_quantity.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Block 2, of weight 9810, falls onto the floor.
const std::string brick = preliminary() + rectangle(-5, -1, 5, 0, true) +
                          rectangle(0, 0.01, 1, 1.01) +
                          "GRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.5\n";

TEST(UnbalancedForces, AreInTheFramesOfADeckWithSolve) {
  const TemporaryFolder folder;
  run_text(folder, "a", brick + "PLOTS, 0.02\nCYCLE, 60\nSOLVE, 1.E-6, 40\nSTOP\n");
  const post::ResultsReader results((folder / "a.vtkhdf").string());
  ASSERT_TRUE(results.has_unbalanced());
  ASSERT_GE(results.frames(), 3);
  const post::Frame falling = results.frame(1);  // 0.02 after the start
  EXPECT_NEAR(falling.unbalanced_ratio, 1.0, 1e-12);
  EXPECT_NEAR(falling.unbalanced[1], 9810.0, 1e-9);
  EXPECT_EQ(falling.unbalanced[0], 0.0);  // fixed
  const auto solve = summary(folder, "a")["solves"][0];
  const post::Frame end = results.frame(results.frames() - 1);
  EXPECT_EQ(end.unbalanced_ratio, solve["reached"]);
  EXPECT_EQ(end.unbalanced.maxCoeff(), solve["largest_unbalanced"]["force"]);
}

// Multiples of the interval are at steps, which are also those of the frames.
TEST(UnbalancedForces, AreRecordedAsInTheFrames) {
  const TemporaryFolder folder;
  run_text(folder, "a",
           brick + "PLOTS, 0.02\nHISTORY, 0.02, unbalanced_ratio, unbalanced:2\n"
                   "CYCLE, 200\nSTOP\n");
  const post::ResultsReader results((folder / "a.vtkhdf").string());
  const post::RecordedHistory recorded = results.recorded().at(0);
  double largest_change = 0.0;
  for (int k = 0; k < 5; ++k) {
    const post::Frame frame = results.frame(k);
    const double ratio = recorded.values(0, k), force = recorded.values(1, k);
    EXPECT_NEAR(frame.time, 0.02 * k, 1e-12);
    EXPECT_NEAR(ratio, frame.unbalanced_ratio, 1e-9);
    EXPECT_NEAR(force, frame.unbalanced[1], 1e-5);
    largest_change = std::max(largest_change, std::abs(ratio - 1.0));
  }
  EXPECT_GT(largest_change, 0.1) << "nothing touched";
}

TEST(UnbalancedForces, AreAbsentUnlessTheDeckAsksForEquilibrium) {
  const TemporaryFolder folder;
  run_text(folder, "a", brick + "CYCLE, 40\nSTOP\n");
  for (const char* command :
       {"plot a.vtkhdf --colour unbalanced -o a.svg",
        "history a.vtkhdf -q unbalanced_ratio", "history a.vtkhdf -q unbalanced:2"}) {
    const Outcome refused = blocks(command, folder.path());
    EXPECT_NE(refused.code, 0) << command;
    EXPECT_THAT(refused.err, HasSubstr("the results have no unbalanced forces\n"
                                       "  hint: a run writes them if its deck has "
                                       "SOLVE"));
  }
  ASSERT_EQ(blocks("export a.vtkhdf -o a.csv", folder.path()).code, 0);
  EXPECT_THAT(slurp(folder / "a.csv"), Not(HasSubstr("unbalanced")));
  const post::ResultsReader results((folder / "a.vtkhdf").string());
  EXPECT_THAT(post::view_data(results, 1).meta, Not(HasSubstr("unbalanced")));
}

// One block carries nearly all of the unbalanced force, so the colours follow decades.
TEST(UnbalancedForces, HaveColoursByDecades) {
  const TemporaryFolder folder;
  run_text(folder, "a", brick + "SOLVE, 1.E-6, 40\nSTOP\n");
  ASSERT_EQ(blocks("plot a.vtkhdf --colour unbalanced -o a.svg", folder.path()).code,
            0);
  const std::string figure = slurp(folder / "a.svg");
  for (const char* text :
       {"ratio 1, largest in block 2", "unbalanced force", "10⁴", "10²", "10⁰"})
    EXPECT_THAT(figure, HasSubstr(text));
  const post::ResultsReader results((folder / "a.vtkhdf").string());
  EXPECT_THAT(post::view_data(results, 1).meta, HasSubstr("\"unbalanced\""));
}

}  // namespace
}  // namespace blocks::testing
