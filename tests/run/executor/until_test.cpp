// --until T ends a run at a time of the deck. With --restart it continues a run that
// has finished. Parts have the bits of one run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

class Until : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const TemporaryFolder* folder : {&straight_, &parts_})
      folder->write("a.deck", layers_and_loads);
  }
  void run(const TemporaryFolder& folder, const std::string& more, int code = 0) {
    const Outcome run = blocks("run a.deck -q " + more, folder.path());
    ASSERT_EQ(run.code, code) << more << run.err;
  }
  void expect_same_runs() {
    expect_same(left_by_run(parts_.path(), "a"), left_by_run(straight_.path(), "a"),
                "--until");
  }
  TemporaryFolder straight_, parts_;
};

const std::string restart = "--restart a.ckpt.h5 ";

// The deck ends at 0.18.
TEST_F(Until, ContinuesAFinishedRunWithTheBitsOfOneRun) {
  run(straight_, "--until 0.3");
  run(parts_, "");
  run(parts_, restart + "--until 0.25");
  run(parts_, restart + "--until 0.3 --stop-after 20", 75);
  run(parts_, restart + "--until 0.3");
  expect_same_runs();
  EXPECT_NEAR(summary(parts_, "a")["time"], 0.3, 0.0005);
}

TEST_F(Until, EndsARunInsideTheDeck) {
  run(straight_, "");
  run(parts_, "--until 0.03");
  EXPECT_NEAR(summary(parts_, "a")["time"], 0.03, 0.0005);
  EXPECT_EQ(summary(parts_, "a")["status"], "done");
  run(parts_, restart + "--until 0.07");
  EXPECT_NEAR(summary(parts_, "a")["time"], 0.07, 0.0005);
  run(parts_, restart);
  expect_same_runs();
}

// The time is that of the end of the first MOTION, so the later cards do not act.
TEST_F(Until, EndsARunBetweenTwoCards) {
  run(straight_, "");
  run(parts_, "--until 0.06");
  EXPECT_LT(summary(parts_, "a")["blocks"], summary(straight_, "a")["blocks"]);
  run(parts_, restart);
  expect_same_runs();
}

TEST_F(Until, ContinuesARunOfARestartDeck) {
  for (const TemporaryFolder* folder : {&straight_, &parts_}) {
    run(*folder, "");
    folder->write("on.deck", "RESTART, a.ckpt.h5\nCYCLE, 20\nDUMP\n");
  }
  ASSERT_EQ(blocks("run on.deck --until 0.25", straight_.path()).code, 0);
  ASSERT_EQ(blocks("run on.deck", parts_.path()).code, 0);
  ASSERT_EQ(blocks("run on.deck --restart on.ckpt.h5 --until 0.25", parts_.path()).code,
            0);
  expect_same(left_by_run(parts_.path(), "on"), left_by_run(straight_.path(), "on"),
              "--until with RESTART");
}

TEST_F(Until, MustBeLaterThanTheCheckpoint) {
  run(parts_, "");
  const std::string listing = slurp(parts_ / "a.out");
  const Outcome early = blocks("run a.deck " + restart + "--until 0.1", parts_.path());
  EXPECT_EQ(early.code, 2);
  EXPECT_THAT(early.err,
              HasSubstr("blocks: error: --until 0.1 is not later than the time of "
                        "a.ckpt.h5, 0.1"));
  EXPECT_EQ(slurp(parts_ / "a.out"), listing);
}

TEST_F(Until, IsBlamedInsteadOfTheDeck) {
  const Outcome far = blocks("run a.deck --until 1e300", parts_.path());
  EXPECT_EQ(far.code, 3);
  EXPECT_THAT(far.err,
              HasSubstr("--until 1e+300: error: MOTION: 1e+300 would take more "
                        "than 1e+15 steps of "));
}

// All blocks are removed at the end of the deck, so that only --until would move them.
TEST_F(Until, IsBlamedIfNothingIsLeftToMove) {
  const std::string one = preliminary() + rectangle(0, 0, 1, 1) + "MOTION, 0.01\n";
  run_text(parts_, "gone", one + "REMOVE, 1\n");
  const std::string listing = slurp(parts_ / "gone.out"),
                    report = slurp(parts_ / "gone.summary.json"),
                    message = "--until 0.3: error: MOTION: all blocks are removed, so "
                              "there is nothing to move\n";
  const Outcome later =
      blocks("run gone.deck --restart gone.ckpt.h5 --until .3", parts_.path());
  EXPECT_EQ(later.code, 3);
  EXPECT_THAT(later.err, HasSubstr(message));
  EXPECT_EQ(slurp(parts_ / "gone.out"), listing);
  EXPECT_EQ(slurp(parts_ / "gone.summary.json"), report);
  // Only the run knows what is inside the outline.
  parts_.write("out.deck", one + "REMOVE, , , , 4\n-9, -9, 9, 9\n-9, 9, 9, -9\n");
  const Outcome run = blocks("run out.deck --until .3", parts_.path());
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr(message));
}

TEST_F(Until, IsAskedForAgainIfTheRunWasStoppedOnItsWay) {
  run(parts_, "--until 0.3 --stop-after 700", 75);
  const Outcome stopped = blocks("run a.deck " + restart, parts_.path());
  EXPECT_EQ(stopped.code, 5);
  EXPECT_THAT(
      stopped.err,
      HasSubstr("it was stopped on the way to the time of --until; give --until "
                "TIME again"));
}

}  // namespace
}  // namespace blocks::testing
