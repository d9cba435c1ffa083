// SAVE writes checkpoints by name, and PLOTS counts steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string brick = preliminary() + rectangle(-5, -1, 5, 0, true) +
                          rectangle(0, 0.01, 1, 1.01) +
                          "GRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.5\n";

std::vector<long> steps_of(const TemporaryFolder& folder, const std::string& name) {
  const post::ResultsReader results((folder / (name + ".vtkhdf")).string());
  std::vector<long> steps;
  for (long i = 0; i < results.frames(); ++i)
    steps.push_back(results.frame(i).step);
  return steps;
}

TEST(SaveCard, LetsAnotherDeckContinueFromItsName) {
  const TemporaryFolder folder;
  run_text(folder, "a",
           brick +
               "SOLVE, 1.E-4\nSAVE, rest\nSETVEL, 2, , 1., 0.\nMOTION, .02\nSTOP\n");
  ASSERT_TRUE(folder.holds("rest.ckpt.h5"));
  for (const char* name : {"rest", "rest.ckpt.h5"}) {
    run_text(folder, "b",
             std::string("RESTART, ") + name +
                 "\nSETVEL, 2, , 1., 0.\nMOTION, .02\nSTOP\n");
    EXPECT_EQ(summary(folder, "b")["state_hash"], summary(folder, "a")["state_hash"]);
    EXPECT_EQ(summary(folder, "b")["steps"], summary(folder, "a")["steps"]);
  }
}

// The same deck goes on behind its SAVE card, also behind one before the first motion.
TEST(SaveCard, LetsItsOwnDeckGoOn) {
  const TemporaryFolder folder;
  const std::string deck =
      brick + "SAVE, begin\nMOTION, .02\nSAVE, middle\nMOTION, .02\nSTOP\n";
  run_text(folder, "a", deck);
  const auto whole = summary(folder, "a");
  const std::vector<long> frames = steps_of(folder, "a");
  const std::string listing = slurp(folder / "a.out");
  for (const char* name : {"begin", "middle"}) {
    const Outcome run =
        blocks(std::string("run a.deck --restart ") + name + ".ckpt.h5", folder.path());
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(summary(folder, "a")["state_hash"], whole["state_hash"]) << name;
    EXPECT_EQ(steps_of(folder, "a"), frames) << name;
    if (std::string(name) == "middle") {
      EXPECT_EQ(slurp(folder / "a.out"), listing);
    }
  }
}

// Results have the equilibrium of each stage, and the final state once.
TEST(Frames, AreWrittenAtTheEndOfEachSolve) {
  const TemporaryFolder folder;
  const std::string stages =
      brick + "SOLVE, 1.E-4\nFRICTN, .4\nCYCLE, 5\nSOLVE, 1.E-4\n";
  run_text(folder, "a", stages + "SAVE, end\nSTOP\n");
  const auto solves = summary(folder, "a")["solves"];
  const long first = solves[0]["steps"], last = summary(folder, "a")["steps"];
  EXPECT_THAT(steps_of(folder, "a"), ElementsAre(0, first, last));
  run_text(folder, "b", stages + "SETVEL, 2, , 1., 0.\nSTOP\n");
  EXPECT_THAT(steps_of(folder, "b"), ElementsAre(0, first, last, last));
  // They are the same after a restart between both.
  folder.write("c.deck", stages + "SAVE, end\nSTOP\n");
  const std::string part = std::to_string(first + 2);
  ASSERT_EQ(blocks("run c.deck --stop-after " + part, folder.path()).code, 75);
  ASSERT_EQ(blocks("run c.deck --restart c.ckpt.h5", folder.path()).code, 0);
  EXPECT_EQ(steps_of(folder, "c"), steps_of(folder, "a"));
}

// Three decks, one file with all frames, and a block that is named by its place.
TEST(SaveCard, LetsAStudyGoOnInStages) {
  const TemporaryFolder folder;
  const std::string same = "-o study -j 1";
  run_text(folder, "a",
           preliminary() + rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
               rectangle(0, 1, 1, 2) + rectangle(0, 2, 1, 3) +
               "GRAVITY, 0, -9.81\nFRICTN, .5\nLOCDAMP\nSOLVE\nSAVE, high\nSTOP\n",
           same);
  const char* next = "HISTORY, .01, y:at(.5, 2.5)\n";
  run_text(folder, "b",
           std::string("RESTART, high\n") + next +
               "REMOVE, at(.5, .5)\nSOLVE\nSAVE, low\nSTOP\n",
           same);
  run_text(folder, "c", "RESTART, low\nREMOVE, at(.5, .5)\nSOLVE\nSTOP\n", same);
  const auto stages = summary(folder, "study")["solves"];
  ASSERT_EQ(stages.size(), 3U);
  for (const auto& stage : stages)
    EXPECT_EQ(stage["converged"], true);
  EXPECT_EQ(steps_of(folder, "study").size(), 4U);
  EXPECT_EQ(summary(folder, "study")["removed_blocks"], 2);
  const post::ResultsReader results((folder / "study.vtkhdf").string());
  EXPECT_NEAR(results.frame(3).centroid(1, 3), 0.5, 0.01);  // of the upper brick
}

TEST(SaveCard, IsBesideTheOtherFilesOfTheRun) {
  const TemporaryFolder folder;
  run_text(folder, "a", brick + "CYCLE, 5\nSAVE, rest\nSTOP\n", "-o out/x");
  EXPECT_TRUE(folder.holds("out/rest.ckpt.h5"));
  run_text(folder, "b", "RESTART, rest\nCYCLE, 5\nSTOP\n", "-o out/y");
  EXPECT_TRUE(folder.holds("out/y.vtkhdf"));
}

TEST(SaveCard, OverwritesNothingOfOthers) {
  const TemporaryFolder folder;
  folder.write("rest.ckpt.h5", "letters\n");
  folder.write("rest.ckpt.h5.bak", "older letters\n");
  const Outcome run = run_text(folder, "a", brick + "CYCLE, 5\nSAVE, rest\nSTOP\n");
  EXPECT_THAT(run.err, HasSubstr("rest.ckpt.h5 was not written by this deck: the old "
                                 "file is kept with the extension .bak2"));
  EXPECT_EQ(slurp(folder / "rest.ckpt.h5.bak"), "older letters\n");
  EXPECT_EQ(slurp(folder / "rest.ckpt.h5.bak2"), "letters\n");
  // The same deck again keeps the old state as .prev.
  const std::string before = slurp(folder / "rest.ckpt.h5");
  const Outcome again = run_text(folder, "a", brick + "CYCLE, 5\nSAVE, rest\nSTOP\n");
  EXPECT_THAT(again.err, Not(HasSubstr("was not written")));
  EXPECT_EQ(slurp(folder / "rest.ckpt.h5.prev"), before);
  const Outcome other = run_text(folder, "b", brick + "CYCLE, 6\nSAVE, rest\nSTOP\n");
  EXPECT_THAT(other.err, HasSubstr("the extension .bak3"));
  EXPECT_FALSE(folder.holds("rest.lock"));
}

TEST(SaveCard, RefusesNamesThatAreTaken) {
  const TemporaryFolder folder;
  folder.write("a.deck", brick + "CYCLE, 5\nSAVE, x\nSAVE, x.ckpt.h5\nSAVE, a\n"
                                 "SAVE, sub/x\nSTOP\n");
  const Outcome run = blocks("check a.deck", folder.path());
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("SAVE: 'x.ckpt.h5' is already the name of the SAVE "
                                 "card in line "));
  EXPECT_THAT(run.err,
              HasSubstr("SAVE: a.ckpt.h5 is the checkpoint of the run itself"));
  EXPECT_THAT(run.err, HasSubstr("SAVE: the name 'sub/x' has a folder"));
  run_text(folder, "b", brick + "CYCLE, 5\nSAVE, x\nSTOP\n");
  folder.write("c.deck", "RESTART, x\nCYCLE, 5\nSAVE, x\nSTOP\n");
  EXPECT_THAT(blocks("check c.deck", folder.path()).err,
              HasSubstr("x.ckpt.h5 is the checkpoint from which the deck continues"));
}

TEST(Frames, AreWrittenEveryNSteps) {
  const TemporaryFolder folder;
  const std::string deck = brick + "CYCLE, 7\nPLOTS, , 10\nCYCLE, 25\nCYCLE, 6\n"
                                   "PLOTS, .004\nCYCLE, 12\nSTOP\n";
  run_text(folder, "a", deck);
  EXPECT_THAT(steps_of(folder, "a"), ElementsAre(0, 17, 27, 37, 48, 50));
  folder.write("b.deck", deck);
  ASSERT_EQ(blocks("run b.deck --stop-after 20", folder.path()).code, 75);
  ASSERT_EQ(blocks("run b.deck --restart b.ckpt.h5", folder.path()).code, 0);
  EXPECT_EQ(steps_of(folder, "b"), steps_of(folder, "a"));
}

}  // namespace
}  // namespace blocks::testing
