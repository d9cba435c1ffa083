// The command `blocks study contacts`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(StudyCommand, WritesTableCsvAndJson) {
  const TemporaryFolder folder;
  folder.write("t.csv", "older");
  const Outcome done = blocks("study contacts tee figure4b --frames 3 --steps 20 "
                              "--variants default,report --csv t.csv --json t.json",
                              folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("3 frames of 20 steps"));
  EXPECT_THAT(done.out, HasSubstr("0/3 0-56"));
  const std::string csv = slurp(folder / "t.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_THAT(csv, HasSubstr("\nfigure4b,report,3,20,"));
  EXPECT_EQ(slurp(folder / "t.csv.bak"), "older");
  const auto json = nlohmann::json::parse(slurp(folder / "t.json"));
  EXPECT_EQ(json["studies"][0]["variants"][0]["hang_ups"]["value"], 0.0);
}

// A frame of a scene is a deck that runs.
TEST(StudyCommand, WritesAFrameAsADeck) {
  const TemporaryFolder folder;
  const Outcome written = blocks("study contacts cut --first 24 --frames 1 --steps 20 "
                                 "--variants default --deck frame.deck",
                                 folder.path());
  ASSERT_EQ(written.code, 0) << written.err;
  EXPECT_THAT(slurp(folder / "frame.deck"), HasSubstr("$ The domain in one piece:"));
  const Outcome done = blocks("run frame.deck", folder.path());
  EXPECT_EQ(done.code, 0) << done.err;
}

TEST(StudyCommand, RunsADeck) {
  const TemporaryFolder folder;
  const Outcome done =
      blocks("study contacts " BLOCKS_SOURCE_DIR "/decks/stack/stack.deck --frames 2 "
             "--steps 100 --variants default",
             folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("0/2 0-66"));
  EXPECT_THAT(done.out, HasSubstr("the deck's own MOTION, CYCLE and SOLVE are replaced "
                                  "by 100 steps\n"));
  // The blocks move, but end near their start.
  EXPECT_THAT(done.out, HasSubstr("hang-ups: not counted, because the expected motion "
                                  "ends near its start"));
  EXPECT_EQ(blocks("study contacts none.deck", folder.path()).code, 5);
}

// A block that falls sinks deep into soft ground and is thrown up, so the run cannot
// tell what hangs.
TEST(StudyCommand, CountsNothingForADeckWithoutAReference) {
  const TemporaryFolder folder;
  folder.write("fall.deck", preliminary() + rectangle(0, 0, 5, 1, true) +
                                rectangle(2, 4, 3, 5) +
                                "GRAVITY, 0, -9.81\nMOTION, 1\n");
  const Outcome done = blocks("study contacts fall.deck --frames 3 --steps 4000 "
                              "--variants default --gate --json t.json",
                              folder.path());
  EXPECT_THAT(done.out, HasSubstr("hang-ups and fall-throughs: not counted, because\n"
                                  "  the run of default lets two blocks overlap"));
  EXPECT_THAT(done.out, Not(HasSubstr("hung in frame")));
  EXPECT_THAT(done.out, Not(HasSubstr("/3")));
  EXPECT_THAT(done.err, HasSubstr("so they are not counted\n"));
  EXPECT_THAT(done.err, HasSubstr("--gate failed: fall.deck"));
  EXPECT_EQ(done.code, 4);
  const auto json = nlohmann::json::parse(slurp(folder / "t.json"));
  EXPECT_TRUE(json["studies"][0]["variants"][0]["hang_ups"]["value"].is_null());
}

// At 1e12 block sizes doubles are coarser than the slack, and a block hangs in frame 9.
TEST(StudyCommand, FailsAtTheGateWithTheReason) {
  const TemporaryFolder folder;
  const std::string one = "study contacts diagonal --first 9 --frames 1 --gate "
                          "--variants default --offset ";
  const Outcome far = blocks(one + "1e12", folder.path());
  EXPECT_EQ(far.code, 4);
  EXPECT_THAT(far.out, HasSubstr("default hung in frame 9"));
  EXPECT_THAT(far.err, HasSubstr("blocks: error: --gate failed: diagonal: of 1 frames, "
                                 "1 hung and 0 fell through"));
  EXPECT_EQ(blocks(one + "1e3", folder.path()).code, 0);
}

TEST(StudyCommand, NamesTheScenesIfOneIsUnknown) {
  const TemporaryFolder folder;
  const Outcome scene = blocks("study contacts figure4", folder.path());
  EXPECT_EQ(scene.code, 2);
  EXPECT_THAT(scene.err, HasSubstr("no scene 'figure4'; did you mean figure4b?"));
  EXPECT_THAT(scene.err, HasSubstr("\n  shaft "));
}

TEST(StudyCommand, NamesTheVariantsIfOneIsUnknown) {
  const TemporaryFolder folder;
  const Outcome variant =
      blocks("study contacts tee --variants default,exakt", folder.path());
  EXPECT_EQ(variant.code, 2);
  EXPECT_THAT(variant.err, HasSubstr("there is no variant 'exakt'"));
  EXPECT_THAT(variant.err, HasSubstr("\n  no-joints "));
}

TEST(StudyCommand, RefusesWrongArguments) {
  const TemporaryFolder folder;
  EXPECT_EQ(blocks("study contacts", folder.path()).code, 2);
  const Outcome seed = blocks("study contacts tee --seed -1", folder.path());
  EXPECT_EQ(seed.code, 2);
  EXPECT_THAT(seed.err, HasSubstr("blocks: error: --seed: expected a whole number from "
                                  "0 to 9007199254740992, found '-1'"));
  const Outcome study = blocks("study contact", folder.path());
  EXPECT_EQ(study.code, 2);
  EXPECT_THAT(study.err, HasSubstr("no study 'contact'; the only one is contacts"));
  EXPECT_EQ(blocks("study contacts tee --csv x --json x", folder.path()).code, 5);
}

// A plate with thickness 1e-9 can be made near the origin only.
TEST(StudyCommand, WritesTheResultsOfOtherDecksIfOneFails) {
  const TemporaryFolder folder;
  folder.write("thin.deck", preliminary() + rectangle(0, 0, 1, 1e-9, true) +
                                rectangle(2, 0, 3, 1) + "STOP\n");
  const Outcome far = blocks("study contacts tee thin.deck slab --frames 2 --steps 5 "
                             "--variants default,skin --offset 1e9 --csv t.csv",
                             folder.path());
  EXPECT_EQ(far.code, 3);
  EXPECT_THAT(far.err, HasSubstr("blocks: error: thin.deck was not run: block 1 is too "
                                 "small for the doubles there"));
  EXPECT_THAT(far.err, HasSubstr("hint: "));
  const std::string csv = slurp(folder / "t.csv");
  EXPECT_THAT(csv, HasSubstr("\ntee,default,2,"));
  EXPECT_THAT(csv, HasSubstr("\nslab,skin,2,"));
}

TEST(StudyCommand, SaysWhichVariantCannotRun) {
  const TemporaryFolder folder;
  folder.write("thin.deck", preliminary() + rectangle(0, 0, 1, 1e-9, true) +
                                rectangle(2, 0, 3, 1) + "STOP\n");
  const Outcome near = blocks("study contacts thin.deck --frames 2 --steps 5 "
                              "--variants default,skin --offset 0 --csv t.csv",
                              folder.path());
  EXPECT_EQ(near.code, 0) << near.err;
  EXPECT_THAT(near.out, HasSubstr("skin not run: block 1 is too small for a skin"));
  EXPECT_THAT(slurp(folder / "t.csv"), HasSubstr("\nthin.deck,skin,0,"));
}

TEST(StudyCommand, FindsAMissingDeckBeforeItRuns) {
  const TemporaryFolder folder;
  const Outcome late = blocks("study contacts tee none.deck", folder.path());
  EXPECT_EQ(late.code, 5);
  EXPECT_EQ(late.out, "");
}

TEST(StudyCommand, TestsItsOutputFilesBeforeItRuns) {
  const TemporaryFolder folder;
  for (const char* outputs : {"--csv .", "--json none/t.json", "--figure none/t.png",
                              "--csv t.txt --json ./t.txt"}) {
    const Outcome done =
        blocks(std::string("study contacts tee ") + outputs, folder.path());
    EXPECT_EQ(done.code, 5) << outputs;
    EXPECT_EQ(done.out, "") << outputs;
    EXPECT_THAT(done.err, HasSubstr("blocks: error: cannot write ")) << outputs;
  }
}

// The expected distances are those of the run of the deck itself. If that run fails,
// the table shows no hang-up.
TEST(StudyCommand, WarnsIfTheRunOfTheDeckItselfFails) {
  const TemporaryFolder folder;
  const std::string blocks_on_a_floor =
      preliminary() + rectangle(-2, -1, 2, 0, true) + rectangle(-0.5, 0, 0.5, 1);
  const auto warned = [&](const std::string& cards) {
    folder.write("t.deck", blocks_on_a_floor + cards + "CYCLE, 1\nSTOP\n");
    const Outcome done = blocks("study contacts t.deck --frames 1 --steps 400 "
                                "--variants default",
                                folder.path());
    EXPECT_EQ(done.code, 0) << done.err;
    return done.err;
  };
  // With the first gravity the block overlaps by a tenth. With the second one it falls
  // through the floor within 70 steps.
  for (const char* gravity : {"GRAVITY, 0, -2E3\nDAMPING, 0.3\n", "GRAVITY, 0, -1E5\n"})
    EXPECT_THAT(warned(gravity),
                HasSubstr("blocks: warning: t.deck: the run of default, which is the "
                          "expected motion, lets two blocks overlap by more than 2 %"));
  EXPECT_THAT(warned("GRAVITY, 0, -1E200\n"),
              HasSubstr("is unsound: numbers are not finite after step 1"));
  EXPECT_EQ(warned("GRAVITY, 0, -10\nDAMPING, 0.3\n"), "");
}

}  // namespace
}  // namespace blocks::testing
