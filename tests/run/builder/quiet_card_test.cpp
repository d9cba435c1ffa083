// QUIET: what the card sets, and what the program tells about it. Errors are in
// tests/corpus/bad_cards/QUIET.txt and bad_run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "run/run.hpp"
#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string two_boxes = rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 2, 1);

class QuietCard : public ::testing::Test {
 protected:
  /// Builds the model of these cards after two boxes. The messages are in `said_`.
  Model built(const std::string& cards, const std::string& before_end = "") {
    folder_.write("quiet.deck",
                  preliminary(before_end) + two_boxes + cards + "CYCLE, 1\n");
    run::RunOptions options;
    options.deck = (folder_ / "quiet.deck").string();
    ::testing::internal::CaptureStderr();
    run::CheckedDeck checked = run::build_checked(options);
    said_ = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(checked.code, run::done) << said_;
    return std::move(checked.model);
  }
  TemporaryFolder folder_;
  std::string said_;
};

TEST_F(QuietCard, FreesItsBlockAndTakesTheSpeedsOfTheMaterial) {
  const Model model = built("QUIET, 1, 4\n");
  ASSERT_EQ(model.loads.quiet_sides.size(), 1U);
  const QuietSide& quiet = model.loads.quiet_sides[0];
  const Material& material = model.settings.materials.at(1);
  EXPECT_EQ(quiet.block, 0);
  EXPECT_EQ(quiet.side, 3);
  EXPECT_EQ(quiet.cp, std::sqrt(material.c11() / material.density));
  EXPECT_EQ(quiet.cs, std::sqrt(material.shear_modulus / material.density));
  EXPECT_TRUE(model.blocks.is_free(0));
}

TEST_F(QuietCard, TakesTheSpeedsOfTheCard) {
  QuietSide quiet = built("QUIET, 1, 4, 300., 200.\n").loads.quiet_sides.at(0);
  EXPECT_EQ(quiet.cp, 300.0);
  EXPECT_EQ(quiet.cs, 200.0);
  quiet = built("QUIET, 1, 4, 300.\n", "RIGID\n").loads.quiet_sides.at(0);
  EXPECT_EQ(quiet.cs, 150.0);
  EXPECT_EQ(said_, "");
}

TEST_F(QuietCard, WarnsOfSpeedsThatNoSolidHas) {
  built("QUIET, 1, 4, 200., 300.\n");
  EXPECT_THAT(said_, HasSubstr("warning: QUIET: cs = 300 is greater than cp = 200\n"));
  EXPECT_THAT(said_, HasSubstr("hint: shear waves are slower than compression waves in "
                               "every elastic solid\n"));
}

TEST_F(QuietCard, WarnsOfABlockThatNothingHolds) {
  built("GRAVITY, 0, -9.8\nQUIET, 1, 4, 300.\n");
  EXPECT_THAT(said_,
              HasSubstr("warning: QUIET: block 1 is freed before the first step, "
                        "so only its own weight is held\n"));
  EXPECT_THAT(said_,
              HasSubstr("hint: bring the model to rest on the fixed block first: "
                        "SOLVE or MOTION\n"));
  built("GRAVITY, 0, -9.8\nCYCLE, 1\nQUIET, 1, 4, 300.\n");
  EXPECT_THAT(said_, Not(HasSubstr("is freed before the first step")));
  built("GRAVITY, 0, -9.8\nQUIET, 2, 4, 300.\n");
  EXPECT_THAT(said_, Not(HasSubstr("is freed before the first step")));
}

// The dashpots take cp dt / h of the velocity in a step.
TEST_F(QuietCard, WarnsOfDashpotsThatAreTooStiff) {
  built("QUIET, 2, 1, 1.E6, 1.E6\n", "RIGID\n");
  EXPECT_THAT(said_, HasSubstr("warning: QUIET: the dashpots of block 2 would take "));
  EXPECT_THAT(said_, HasSubstr("times its velocity in a time step of "));
  EXPECT_THAT(said_, HasSubstr("may be unstable: reduce FRACTION, or cp and cs\n"));
}

TEST_F(QuietCard, IsInTheListing) {
  const std::string deck = preliminary() + two_boxes +
                           "GRAVITY, 0, -9.8\nDAMPING, .5\nMOTION, 1.\n"
                           "QUIET, 1, 4, 300., 200.\nCYCLE, 2\nDUMP\nSTOP\n";
  const Outcome run = run_text(folder_, "quiet", deck);
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string listing = slurp(folder_ / "quiet.out");
  EXPECT_THAT(listing,
              HasSubstr("side 4 of block 1, cp 300, cs 200; the block is freed "
                        "and held by the constant force ("));
}

// The run stops before the card, at it and after it.
TEST_F(QuietCard, RunIsResumedToTheBit) {
  const std::string deck =
      preliminary() + two_boxes +
      "GRAVITY, 0, -9.8\nDAMPING, .5\nPLOTS, .05\nHISTORY, .01, energy:quiet, y:1\n"
      "CYCLE, 300\nQUIET, 1, 4, 300., 200.\nQUIET, 1, 1, 300., 200.\n"
      "SETVEL, 2, 2, .1, -.1\nCYCLE, 300\n";
  TemporaryFolder parts;
  run_text(folder_, "quiet", deck);
  parts.write("quiet.deck", deck);
  std::string restart;
  for (const char* stop : {"150", "150", "101"}) {
    ASSERT_EQ(
        blocks("run quiet.deck" + restart + " --stop-after " + stop, parts.path()).code,
        75);
    restart = " --restart quiet.ckpt.h5";
  }
  ASSERT_EQ(blocks("run quiet.deck" + restart, parts.path()).code, 0);
  expect_same(left_by_run(parts.path(), "quiet"), left_by_run(folder_.path(), "quiet"),
              "stops");
}

}  // namespace
}  // namespace blocks::testing
