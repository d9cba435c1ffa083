// CRACK in a run: warnings about cards by which nothing can split, refused cracks, and
// results that do not depend on threads, restarts or the internal order of the blocks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A block that is pulled apart, and a smaller one beside it.
const std::string pulled = preliminary("FUNCTION, 1\n0., 1.\n") +
                           rectangle(0, 0, 1, 1) + rectangle(3, 0, 3.5, 0.5) +
                           "PRESSBC, 1, 1, -1.2E6, -1.2E6\n"
                           "PRESSBC, 1, 3, -1.2E6, -1.2E6\n";

Outcome check(const TemporaryFolder& folder, const std::string& deck) {
  folder.write("c.deck", deck + "MOTION, .001\nSTOP\n");
  return blocks("check c.deck", folder.path());
}

TEST(CrackCard, WarnsIfNoBlockCanSplit) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      check(folder, pulled + "CRACK, 1, 1.E6, .6\n").err,
      AllOf(HasSubstr("c.deck:"),
            HasSubstr("warning: CRACK: no block of material 1 is large enough to "
                      "split: amin is 0.6, the largest area 1"),
            HasSubstr("at least two times amin")));
  EXPECT_THAT(check(folder, pulled + "CRACK, 2, 1.E6, .1\n").err,
              HasSubstr("warning: CRACK: no free block has material 2"));
  EXPECT_THAT(check(folder, pulled + "CRACK, 1, 1.E6, .5\n").err,
              Not(HasSubstr("CRACK")));
}

TEST(CrackCard, TellsOnceWhenStartAllowsNoMoreBlocks) {
  const TemporaryFolder folder;
  std::string deck = pulled + "CRACK, 1, 1.E6, .1\nMOTION, 0.004\nSTOP\n";
  deck.replace(deck.find("100, 6"), 6, "3, 6");
  const Outcome run = run_text(folder, "few", deck);
  EXPECT_THAT(run.err, HasSubstr("did not split: START allows no more blocks"));
  EXPECT_EQ(run.err.find("raise nblokm"), run.err.rfind("raise nblokm"));
  const auto told = summary(folder, "few");
  EXPECT_EQ(told["cracks"].size(), 1U);
  EXPECT_EQ(told["blocks"], 3);
}

// Pieces take the next numbers, so FIX would fix a piece.
TEST(CrackCard, RefusesNumbersOfBlocksMadeAfterAMotionWithCracks) {
  const TemporaryFolder folder;
  const std::string later =
      pulled + "CRACK, 1, 1.E6, .1\nMOTION, .001\n" + rectangle(5, 0, 6, 1);
  EXPECT_THAT(
      check(folder, later + "FIX, 3\n").err,
      AllOf(HasSubstr("error: FIX: the block that gets the number 3 is not known "
                      "before the run"),
            HasSubstr("by material or outline")));
  EXPECT_THAT(check(folder, later + "HISTORY, .001, x:3\n").err,
              HasSubstr("error: HISTORY: the block that gets the number 3"));
  EXPECT_EQ(check(folder, later + "FIX, 2\n").code, 0);
}

// Rigid bricks, numbered at random and stepped in another order, are pulled apart one
// after the other.
TEST(CrackCard, GivesTheSameBitsInAnyOrderOfTheSteps) {
  const TemporaryFolder folder;
  std::string deck = wall_at_random();
  deck.replace(deck.find("RIGID\n"), 6, "FUNCTION, 1\n0., 1.\nRIGID\n");
  deck += "CRACK, 1, 2.E3, .007, 1.E5, 2\n";
  for (int b = 40; b < 80; ++b)
    for (const char* side : {"1", "3"})
      deck += fmt::format("PRESSBC, {}, {}, -4.E3, -4.E3, {}\n", b, side, 2e-5 * b);
  deck += "CYCLE, 60\nSTOP\n";
  folder.write("w.deck", deck);
  const auto run = [&](const std::string& name, const std::string& options) {
    const Outcome outcome =
        blocks("run w.deck -q -o " + name + " " + options, folder.path());
    EXPECT_TRUE(outcome.code == 0 || outcome.code == 75) << outcome.err;
    return outcome;
  };
  run("one", "-j 1");
  const auto one = summary(folder, "one");
  EXPECT_GT(one["cracks"].size(), 20U);
  run("two", "-j 2");
  run("parts", "-j 2 --stop-after 20");
  run("parts", "-j 1 --restart parts.ckpt.h5");
  for (const char* name : {"two", "parts"}) {
    EXPECT_EQ(summary(folder, name)["state_hash"], one["state_hash"]) << name;
    EXPECT_EQ(summary(folder, name)["cracks"], one["cracks"]) << name;
  }
}

}  // namespace
}  // namespace blocks::testing
