// SERVO in runs of the program. Wrong input is in bad_cards.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

/// A box between a floor, a wall and two plates: block 4 at its right and 5 above it.
const std::string pressed_box = rectangle(-4, -1, 4, 0, true) + rectangle(0, 0, 2, 1) +
                                rectangle(-1, 0.1, 0, 0.9, true) +
                                rectangle(2.001, 0.1, 3, 1.1, true) +
                                rectangle(0.1, 1.001, 1.9, 2, true);

TEST(ServoCard, HoldsTheStressWhileTheOtherAxisMoves) {
  TemporaryFolder folder;
  run_text(folder, "box",
           preliminary() + pressed_box +
               "DAMPING, .3\nSERVO, 4, 1, -2.D4, .1\nSERVO, 5, 4, -1.D4, .1\n"
               "MOTION, .5\nDRIVE, 5, 0, -.002\nHISTORY, .01, fx:4, vx:4\n"
               "MOTION, .5\n");
  const auto servo = summary(folder, "box")["servos"].at(0);
  EXPECT_EQ(servo["block"], 4);
  EXPECT_EQ(servo["side"], 1);
  EXPECT_EQ(servo["target"], -2e4);
  EXPECT_NEAR(servo["stress"].get<double>(), -2e4, 1.0);
  EXPECT_LT(servo["speed"].get<double>(), 1e-3);
  post::ResultsReader results((folder / "box.vtkhdf").string());
  const post::Frame last = results.frame(results.frames() - 1);
  EXPECT_NEAR(last.force(0, 3), 2e4, 1.0);
  EXPECT_EQ(last.velocity(1, 3), 0.0);
  EXPECT_GT(last.force(1, 4), 1.5e4);
  EXPECT_EQ(last.velocity(1, 4), -0.002);
}

TEST(ServoCard, IsReplacedAndEndedByOtherCards) {
  TemporaryFolder folder;
  const auto report = [&](const std::string& cards) {
    folder.write("box.deck", preliminary() + pressed_box + cards + "CYCLE, 1\n");
    const Outcome told = blocks("check box.deck", folder.path());
    EXPECT_EQ(told.code, 0) << told.err;
    return told.out;
  };
  const std::string servo = "SERVO, 4, 1, -2.D4, .1\n";
  const std::string line =
      "block 4 is driven by a servo: normal stress -20000 on side 1, speed up to 0.1\n";
  EXPECT_THAT(report(servo), HasSubstr(line));
  EXPECT_THAT(report("DRIVE, 4, 1\nSERVO, 4, 3, 7, 8\n" + servo), HasSubstr(line));
  EXPECT_THAT(report(servo + "DRIVE, 4\n"),
              HasSubstr("block 4 is driven: velocity (0, 0), spin 0\n"));
  for (const char* card : {"FIX, 4\n", "FREE, 4\n", "REMOVE, 4\n"})
    EXPECT_THAT(report(servo + card), ::testing::Not(HasSubstr("servo")));
}

// The run stops four times: while the plates approach, in contact, and after the cards
// that replace the servos.
TEST(ServoCard, RunIsResumedToTheBit) {
  const std::string deck =
      preliminary("") + pressed_box +
      "DAMPING, .2\nFRICTN, .4\nJOINT, 3, .5, , , , , , 10, .01, 1e8\nJPAIR, 1, 1, 3\n"
      "SERVO, 4, 1, -2.D4, .1\nSERVO, 5, 4, -1.D4, .1\nPLOTS, .02\n"
      "HISTORY, .01, fx:4, vx:4, energy:residual\n"
      "MOTION, .06\nDRIVE, 5, 0, -.02\nSERVO, 4, 1, -1.D4, .1\nMOTION, .04\n";
  TemporaryFolder whole, parts;
  run_text(whole, "box", deck);
  parts.write("box.deck", deck);
  const long steps = summary(whole, "box")["steps"];
  ASSERT_GT(steps, 100);
  std::string restart;
  for (const double part : {0.1, 0.3, 0.01, 0.4}) {
    const auto stop = static_cast<long>(part * static_cast<double>(steps));
    ASSERT_EQ(
        blocks("run box.deck -j 2" + restart + " --stop-after " + std::to_string(stop),
               parts.path())
            .code,
        75);
    restart = " --restart box.ckpt.h5";
  }
  ASSERT_EQ(blocks("run box.deck" + restart, parts.path()).code, 0);
  expect_same(left_by_run(parts.path(), "box"), left_by_run(whole.path(), "box"),
              "stops");
}

}  // namespace
}  // namespace blocks::testing
