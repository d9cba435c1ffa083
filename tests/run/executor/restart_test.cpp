// A run continued with RESTART ends in the state of the uninterrupted run, bit for bit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

/// A deck with a name for the list of tests.
struct Case {
  std::string name, deck;
  friend std::ostream& operator<<(std::ostream& out, const Case& one) {
    return out << one.name;
  }
};

const std::string random_layers =
    preliminary("SEED, 3\nRIGID\n") + rectangle(-9, -2, 9, -1, true) +
    "ORIENT, -15, 15\nMERGE, 0.5\n"
    "LAYER, -20, 1, -8,-1, -8,0, 8,0, 8,-1, RANDOM\n"
    "LAYER, -20, 2, -8,0, -8,1, 8,1, 8,0, RANDOM\n"
    "SPLANE, -8, 5, -8, -5\nGRAVITY, 0, -9.81\nFRICTN, 0.4\nDAMPING, 0.3\n"
    "SETVELM, 2, 0.3, 0, 0\nPLOTS, 0.03\nOUTPUT, 0.07, 2, 3\n";

const std::string deformable =
    preliminary("FUNCTION, 3\n0, 0\n0.05, 1\n0.3, 0\n") +
    rectangle(-9, -2, 9, -1, true) +
    "LAYER, -6, 1, -3,-1, -3,0, 3,0, 3,-1\nLAYER, -5, 2, -3,0, -3,1, 3,1, 3,0\n"
    "GRAVITY, 0, -9.81\nFRICTN, 0.4\nDAMPING, 0.1\nPLOTS, 0.03\n"
    "PRESSBC, 2, 1, 1.E4, 2.E4, 0.1\nFORCE, 8, 1.E3, 2.E3, 0.15\n";

class Restart : public ::testing::TestWithParam<Case> {};

// A checkpoint needs contact forces, clocks of OUTPUT and PLOTS, planes, loads and
// stresses for this.
TEST_P(Restart, ContinuesBitForBit) {
  const TemporaryFolder folder;
  run_text(folder, "whole", GetParam().deck + "MOTION, 0.2\nMOTION, 0.2\nSTOP\n");
  run_text(folder, "first", GetParam().deck + "MOTION, 0.2\nSTOP\n", "-o parts");
  const auto half = summary(folder, "parts");
  run_text(folder, "second", "RESTART\nMOTION, 0.2\nSTOP\n", "-o parts");

  const auto whole = summary(folder, "whole"), parts = summary(folder, "parts");
  EXPECT_NE(half["state_hash"], whole["state_hash"]);
  for (const char* key : {"state_hash", "steps", "time", "kinetic_energy", "contacts",
                          "list_updates", "title", "seed", "merges", "layers"})
    EXPECT_EQ(parts[key], whole[key]) << key;
}

// The results have one more frame, written at the end of the first part.
TEST_P(Restart, AppendsFramesToTheResults) {
  const TemporaryFolder folder;
  run_text(folder, "whole", GetParam().deck + "MOTION, 0.2\nMOTION, 0.2\nSTOP\n");
  run_text(folder, "first", GetParam().deck + "MOTION, 0.2\nSTOP\n", "-o parts");
  const double stopped = summary(folder, "parts")["time"];
  run_text(folder, "second", "RESTART\nMOTION, 0.2\nSTOP\n", "-o parts");

  const post::ResultsReader whole((folder / "whole.vtkhdf").string());
  const post::ResultsReader parts((folder / "parts.vtkhdf").string());
  std::vector<double> times = parts.times();
  EXPECT_EQ(std::erase(times, stopped), 1);
  EXPECT_EQ(times, whole.times());
  EXPECT_FALSE(folder.holds("parts.vtkhdf.bak"));
}

INSTANTIATE_TEST_SUITE_P(Decks, Restart,
                         ::testing::Values(Case{"RandomLayers", random_layers},
                                           Case{"Deformable", deformable}),
                         [](const auto& one) { return one.param.name; });

// Seed, number of layers, ORIENT and MERGE are part of the state. The list of 1982 left
// them out.
TEST(RestartOfRandomLayers, CutsTheSameNextLayer) {
  const std::string next = "LAYER, -20, 1, -8,3, -8,4, 8,4, 8,3, RANDOM\nMOTION, 0.1\n";
  const TemporaryFolder folder;
  run_text(folder, "whole", random_layers + "MOTION, 0.1\n" + next);
  run_text(folder, "first", random_layers + "MOTION, 0.1\n");
  run_text(folder, "second", "RESTART, first.ckpt.h5\n" + next);
  const auto whole = summary(folder, "whole"), second = summary(folder, "second");
  EXPECT_EQ(second["state_hash"], whole["state_hash"]);
  EXPECT_EQ(second["merges"], whole["merges"]);
  EXPECT_EQ(second["layers"].size(), 3U);
}

TEST(RestartOption, ReplacesTheFileOfTheCard) {
  const TemporaryFolder folder;
  run_text(folder, "first", deformable + "CYCLE, 20\n");
  run_text(folder, "whole", deformable + "CYCLE, 30\n");
  folder.write("second.deck", "RESTART, nowhere.ckpt.h5\nCYCLE, 10\n");
  const Outcome found =
      blocks("run second.deck --restart first.ckpt.h5", folder.path());
  ASSERT_EQ(found.code, 0) << found.err;
  EXPECT_EQ(summary(folder, "second")["state_hash"],
            summary(folder, "whole")["state_hash"]);
}

TEST(RestartOption, RefusesAFileThatIsNoCheckpoint) {
  const TemporaryFolder folder;
  run_text(folder, "first", deformable + "CYCLE, 20\n");
  folder.write("second.deck", "RESTART, nowhere.ckpt.h5\nCYCLE, 10\n");
  EXPECT_EQ(blocks("run second.deck --restart first.out", folder.path()).code, 5);
}

// A tape that was copied to another machine comes without results and listing.
TEST(RestartCard, NeedsNothingButTheCheckpoint) {
  const TemporaryFolder first, second;
  run_text(first, "a", preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 3\n");
  fs::copy_file(first / "a.ckpt.h5", second / "b.ckpt.h5");
  run_text(second, "b", "RESTART\nCYCLE, 3\n");
  EXPECT_TRUE(second.holds("b.vtkhdf"));
  EXPECT_EQ(summary(second, "b")["steps"], 6);
}

// With -o alone, the checkpoint would be sought under the new name.
TEST(RestartCard, TellsHowToLeaveForeignResultsAlone) {
  const TemporaryFolder folder;
  const std::string deck = preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 3\n";
  run_text(folder, "a", deck);
  run_text(folder, "other", deck + "CYCLE, 1\n");
  fs::copy_file(folder / "other.vtkhdf", folder / "a.vtkhdf",
                fs::copy_options::overwrite_existing);
  folder.write("go.deck", "RESTART\nCYCLE, 3\n");
  const Outcome refused = blocks("run go.deck -o a", folder.path());
  EXPECT_EQ(refused.code, 5);
  EXPECT_THAT(refused.err, HasSubstr("use --restart a.ckpt.h5 -o NAME for new files"));
  EXPECT_EQ(blocks("run go.deck --restart a.ckpt.h5 -o new", folder.path()).code, 0);
}

TEST(RestartCard, IsReportedIfItsFileIsMissing) {
  const TemporaryFolder folder;
  folder.write("second.deck", "RESTART, nowhere.ckpt.h5\nCYCLE, 10\n");
  const Outcome lost = blocks("run second.deck", folder.path());
  EXPECT_EQ(lost.code, 5);
  EXPECT_EQ(
      lost.err,
      "second.deck:1:10: error: RESTART: cannot read nowhere.ckpt.h5: No such file or "
      "directory\n  RESTART, nowhere.ckpt.h5\n           ^~~~~~~~~~~~~~~\n  hint: name "
      "a checkpoint, with or without .ckpt.h5, such as that of a SAVE card; --restart "
      "FILE replaces the name\n1 error\n");
  EXPECT_EQ(blocks("check second.deck", folder.path()).code, 5);
}

}  // namespace
}  // namespace blocks::testing
