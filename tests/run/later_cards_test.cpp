// Cards in the middle of a run, and runs that end early.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string moving = preliminary() + rectangle(0, 0, 1, 1) +
                           rectangle(4, 0, 5, 1) + "SETVEL, 2, 0, 2, 0\nMOTION, 1\n";

// Block 2 has left the place where block 3 is made.
TEST(LaterCreate, MayUseAPlaceThatABlockHasLeft) {
  const TemporaryFolder folder;
  const Outcome free =
      run_text(folder, "free", moving + rectangle(4, 0, 5, 1) + "MOTION, 0.01\n");
  EXPECT_THAT(free.err, Not(HasSubstr("overlap")));
}

// Block 2 has moved to the place where block 3 is made.
TEST(LaterCreate, IsWarnedOfOverlapsWithPresentPositions) {
  const TemporaryFolder folder;
  const Outcome hit =
      run_text(folder, "hit", moving + rectangle(6, 0, 7, 1) + "MOTION, 0.01\n");
  EXPECT_THAT(hit.err, HasSubstr("warning: CREATE: blocks 2 and 3 overlap"));
  EXPECT_THAT(summary(folder, "hit")["warnings"].dump(), HasSubstr("2 and 3 overlap"));
}

TEST(LaterSplane, IsComparedWithPresentPositions) {
  const TemporaryFolder folder;
  // At first all blocks are behind the plane. Block 2 is in front of it later.
  folder.write("late.deck", moving + "SPLANE, 5.5, 5, 5.5, -5\nMOTION, 0.01\n");
  EXPECT_EQ(blocks("run late.deck", folder.path()).code, 0);
}

TEST(LaterSplane, StopsTheRunIfAllBlocksAreBehindIt) {
  const TemporaryFolder folder;
  folder.write("front.deck", moving + "SPLANE, 8, 5, 8, -5\nMOTION, 0.01\n");
  const Outcome front = blocks("run front.deck", folder.path());
  EXPECT_EQ(front.code, 3);
  EXPECT_THAT(front.err,
              HasSubstr("SPLANE: all blocks are on the wrong side of the plane"));
  EXPECT_EQ(summary(folder, "front")["status"], "deck error");
  EXPECT_NEAR(summary(folder, "front")["time"].get<double>(), 1.0, 1e-3);
}

// The limit of the time step depends on FRACTION and DAMPING.
TEST(LaterDamping, IsWarnedOfIfTheTimeStepIsTooLarge) {
  const TemporaryFolder folder;
  folder.write("d.deck", preliminary() + rectangle(0, 0, 1, 1) +
                             "DAMPING, 0.1\nCYCLE, 1\nDAMPING, 0.9\nCYCLE, 1\n");
  const Outcome run = blocks("check d.deck", folder.path());
  EXPECT_THAT(run.err, HasSubstr("FRACTION 0.02 with DAMPING 0.9"));
  EXPECT_THAT(run.err, Not(HasSubstr("DAMPING 0.1 may")));
}

// Cards may come in any order (report A.2.0).
TEST(Output, MayNameLaterBlocks) {
  const TemporaryFolder folder;
  run_text(folder, "o",
           preliminary() + "OUTPUT, 1, 1\n" + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  EXPECT_EQ(summary(folder, "o")["blocks"], 1);
}

TEST(Check, ReportsFaultsOfAllCardsAtOnce) {
  const TemporaryFolder folder;
  folder.write("bad.deck",
               preliminary() + rectangle(0, 0, 1, 1) +
                   "GRAVITY, up\nFIX, 9\nFORCE, 1, 1, 1\nSETVELM, 7, 1, 1\n");
  const Outcome check = blocks("check bad.deck", folder.path());
  EXPECT_EQ(check.code, 3);
  for (const char* fault :
       {"GRAVITY: ", "FIX: there is no block 9", "FORCE: no FUNCTION",
        "SETVELM: there is no material 7", "4 errors"})
    EXPECT_THAT(check.err, HasSubstr(fault));
}

TEST(Motion, IsRefusedIfItHasTooManySteps) {
  const TemporaryFolder folder;
  folder.write("long.deck", preliminary() + rectangle(0, 0, 1, 1) + "MOTION, 1.E300\n");
  const Outcome run = blocks("run long.deck", folder.path());
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err,
              HasSubstr("long.deck:15:9: error: MOTION: 1e+300 would take more"));
}

TEST(Motion, IsWarnedOfIfItHasNoStep) {
  const TemporaryFolder folder;
  const Outcome run = run_text(
      folder, "short", preliminary() + rectangle(0, 0, 1, 1) + "MOTION, 1.E-300\n");
  EXPECT_THAT(run.err, HasSubstr("warning: MOTION: 1e-300 is too short"));
}

TEST(Plots, WritesAFrameInEveryStepIfItsIntervalIsShorter) {
  const TemporaryFolder folder;
  run_text(folder, "p",
           preliminary() + rectangle(0, 0, 1, 1) + "PLOTS, 1.E-320\nCYCLE, 5\n");
  EXPECT_EQ(summary(folder, "p")["frames"], 6);
}

// The largest overlap is updated in every step, also if no frame is written.
TEST(WorstOverlap, DoesNotDependOnPlots) {
  const std::string falling = preliminary() + rectangle(0, 0, 1, 1, true) +
                              rectangle(0, 1.01, 1, 2) +
                              "GRAVITY, 0, -10\nDAMPING, 0.5\n";
  const TemporaryFolder folder;
  run_text(folder, "often", falling + "PLOTS, 0.0004\nCYCLE, 500\n");
  run_text(folder, "never", falling + "CYCLE, 500\n");
  run_text(folder, "half", falling + "CYCLE, 250\n", "-o parts");
  run_text(folder, "rest", "RESTART\nCYCLE, 250\n", "-o parts");
  const auto often = summary(folder, "often")["worst_overlap"];
  EXPECT_GT(often["ever"], often["end"]);
  EXPECT_EQ(summary(folder, "never")["worst_overlap"], often);
  EXPECT_EQ(summary(folder, "parts")["worst_overlap"], often);
}

TEST(Restart, KeepsTheResultsOfAnotherRun) {
  const std::string one = preliminary() + rectangle(0, 0, 1, 1);
  const TemporaryFolder folder;
  run_text(folder, "first", one + "CYCLE, 5\n", "-o x");
  run_text(folder, "other", one + "CYCLE, 7\n", "-o x");
  const std::string listing = slurp(folder / "x.out"),
                    results = slurp(folder / "x.vtkhdf");
  run_text(folder, "again", "RESTART, x.ckpt.h5.bak\nCYCLE, 2\n", "-o x");
  EXPECT_EQ(summary(folder, "x")["steps"], 7);
  EXPECT_EQ(slurp(folder / "x.out.bak2"), listing);
  EXPECT_TRUE(slurp(folder / "x.vtkhdf.bak2") == results);
}

TEST(Restart, CutsTheListingAtTheCheckpoint) {
  const std::string start =
      preliminary() + rectangle(0, 0, 1, 1) + "SETVEL, 1, 0, 1, 0\nOUTPUT, 0.02\n";
  const TemporaryFolder folder;
  run_text(folder, "a", start + "MOTION, 0.1\n", "-o x");
  const std::string before = slurp(folder / "x.out");
  const std::string after = before + "\nOUTPUT of steps that a crash took back\n";
  folder.write("x.out", after);
  run_text(folder, "b", "RESTART\nMOTION, 0.1\n", "-o x");
  EXPECT_EQ(slurp(folder / "x.out").substr(0, before.size()), before);
  EXPECT_THAT(slurp(folder / "x.out"), Not(HasSubstr("a crash took back")));
}

TEST(TimeLimit, SaysHowManyStepsRemainAndHowToContinue) {
  const std::string start =
      preliminary() + rectangle(0, 0, 1, 1) + "SETVEL, 1, 0, 1.E-9, 0\n";
  const TemporaryFolder folder;
  folder.write("long.deck", start + "CYCLE, 100000000\n");
  const Outcome run = blocks("run long.deck --time-limit 0.05", folder.path());
  EXPECT_EQ(run.code, 75);
  const long rest = 100000000 - summary(folder, "long")["steps"].get<long>();
  EXPECT_THAT(run.out + run.err,
              HasSubstr(fmt::format("\n{} steps of this card remain; to continue: "
                                    "blocks run long.deck --restart long.ckpt.h5\n",
                                    rest)));
}

// Springs that are compressed by half a block are unphysical.
TEST(Unsound, RunEndsAndKeepsTheCheckpointIfAnOverlapIsTooDeep) {
  const TemporaryFolder folder;
  run_text(folder, "good",
           preliminary() + rectangle(0, 0, 1, 1, true) + rectangle(0, 1, 1, 2) +
               "CYCLE, 5\n",
           "-o x");
  const std::string good = slurp(folder / "x.ckpt.h5");
  folder.write("away.deck", "RESTART\nGRAVITY, 0, -1.E5\nMOTION, 10\n");
  const Outcome run = blocks("run away.deck -o x", folder.path());
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_THAT(run.err, HasSubstr("is pressed in by"));
  EXPECT_EQ(slurp(folder / "x.ckpt.h5.prev"), good);
}

// The run has no earlier checkpoint.
TEST(Unsound, RunLeavesACheckpointOfItsLastSoundState) {
  const TemporaryFolder folder;
  folder.write("shot.deck", preliminary() + rectangle(0, 0, 1, 1, true) +
                                rectangle(0, 2, 1, 3) +
                                "CYCLE, 70\nSETVEL, 2, 0, 0, -2.E4, 0\nCYCLE, 4\n");
  const Outcome run = blocks("run shot.deck", folder.path());
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_THAT(run.err, HasSubstr("in shot.ckpt.h5"));
  const std::string listing = slurp(folder / "shot.out");
  const auto hash = summary(folder, "shot")["state_hash"];
  folder.write("calm.deck", "RESTART, shot.ckpt.h5\nSETVEL, 2, 0, 0, 0, 0\nCYCLE, 4\n");
  EXPECT_EQ(blocks("run calm.deck", folder.path()).code, 0);
  const Outcome again = blocks("run shot.deck --restart shot.ckpt.h5", folder.path());
  EXPECT_EQ(again.code, 4) << again.err;
  EXPECT_EQ(slurp(folder / "shot.out"), listing);
  EXPECT_EQ(summary(folder, "shot")["state_hash"], hash);
}

TEST(Unsound, RunEndsIfABlockPassesThroughAPlane) {
  const TemporaryFolder folder;
  folder.write("through.deck",
               preliminary() + rectangle(0, 0, 1, 1) +
                   "SPLANE, -1, 0, 2, 0\nGRAVITY, 0, -1.E5\nCYCLE, 400\n");
  const Outcome run = blocks("run through.deck", folder.path());
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_THAT(run.err,
              HasSubstr("a contact of block 1 and a symmetry plane is pressed"));
}

TEST(Unsound, RunEndsIfABlockMayHavePassedThroughAnother) {
  const TemporaryFolder folder;
  folder.write("fast.deck", preliminary() + rectangle(0, 0, 1, 1, true) +
                                rectangle(0, 2, 1, 3) +
                                "SETVEL, 2, 0, 0, -2.E4, 0\nCYCLE, 4\n");
  const Outcome run = blocks("run fast.deck", folder.path());
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_THAT(run.err, HasSubstr("block 2 moved a corner by"));
  EXPECT_THAT(run.err, HasSubstr("it may have passed through another"));
}

TEST(Listing, EchoesADeckWithoutMotion) {
  const TemporaryFolder folder;
  run_text(folder, "still", preliminary() + rectangle(0, 0, 1, 1) + "DUMP\nSTOP\n");
  const std::string listing = slurp(folder / "still.out");
  ASSERT_THAT(listing, HasSubstr("MATERIALS"));
  EXPECT_LT(listing.find("MATERIALS"), listing.find("\nDUMP "));
}

TEST(Create, RefusesSizesWithoutAFiniteMass) {
  const TemporaryFolder folder;
  for (const char* size : {"1.E-200", "1.E200"}) {
    const std::string s = size;
    folder.write("size.deck", preliminary() + "CREATE, 4, 1\n0, 0, " + s + ", " + s +
                                  "\n0, " + s + ", " + s + ", 0\nCYCLE, 1\n");
    const Outcome check = blocks("check size.deck", folder.path());
    EXPECT_EQ(check.code, 3);
    EXPECT_THAT(check.err,
                HasSubstr("size.deck:12:1: error: CREATE: block 1: its area"));
  }
}

TEST(Deck, IsNotOverwrittenByTheListing) {
  const TemporaryFolder folder;
  const std::string deck = preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 1\n";
  folder.write("x.out", deck);
  EXPECT_EQ(blocks("run x.out", folder.path()).code, 2);
  EXPECT_EQ(slurp(folder / "x.out"), deck);
  EXPECT_FALSE(folder.holds("x.out.bak"));
}

TEST(TimeLimit, RefusesTextThatIsNoNumber) {
  const TemporaryFolder folder;
  folder.write("x.deck", preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  EXPECT_EQ(blocks("run x.deck --time-limit nan", folder.path()).code, 2);
}

// A file on a card is relative to the folder of the deck.
TEST(Tape9, OptionIsRelativeToTheCurrentFolder) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "sub");
  folder.write("mesh.txt", "BLOCKS 1\n3, 1\n0 0\n0 1\n1 0\n");
  folder.write("sub/r.deck", preliminary() + "READ9\nCYCLE, 1\n");
  const Outcome run = blocks("check sub/r.deck --tape9 mesh.txt", folder.path());
  EXPECT_EQ(run.code, 0) << run.err;
}

}  // namespace
}  // namespace blocks::testing
