// `blocks check` reports all independent faults of a deck in one pass, and no fault
// that is only a consequence of another one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CheckFaults : public ::testing::Test {
 protected:
  std::string faults_of(const std::string& deck, const std::string& options = {}) {
    folder_.write("bad.deck", deck);
    const Outcome check = blocks("check bad.deck " + options, folder_.path());
    EXPECT_NE(check.code, 0) << deck;
    return check.err;
  }
  TemporaryFolder folder_;
};

const std::string square = rectangle(0, 0, 1, 1);
const std::string of_material_7 = "CREATE, 4, 7\n5, 5, 6, 6\n0, 1, 1, 0\n";

TEST_F(CheckFaults, BehindAMisspeltCardAreReported) {
  EXPECT_THAT(faults_of(preliminary() + square + "GRAVTY, 0, -9.8\n" + of_material_7 +
                        "FIX, 9\nSETVELM, 8, 1, 1\n"),
              AllOf(HasSubstr("unknown card 'GRAVTY'"),
                    HasSubstr("CREATE: there is no material 7"),
                    HasSubstr("FIX: there is no block 9"),
                    HasSubstr("SETVELM: there is no material 8"),
                    HasSubstr("4 errors")));
}

TEST_F(CheckFaults, BehindAnUnknownCardAreReported) {
  EXPECT_THAT(
      faults_of(preliminary() + square + "WIND, 3\n" + of_material_7 + "FIX, 9\n"),
      AllOf(HasSubstr("no material 7"), HasSubstr("no block 9"),
            HasSubstr("3 errors")));
}

// The misspelt cards define material 7 and make block 2.
TEST_F(CheckFaults, OfMisspeltCardsHaveNoConsequences) {
  EXPECT_THAT(faults_of(preliminary("RIGD\nMATERAIL, 7, , , 1000\n") + square +
                        "CREAT, 4, 7\n5, 5, 6, 6\n0, 1, 1, 0\nFIX, 2\n"
                        "SETVELM, 7, 1, 1\nMOTION, 1\n"),
              AllOf(HasSubstr("RIGD"), HasSubstr("MATERAIL"), HasSubstr("CREAT"),
                    HasSubstr("3 errors")));
}

TEST_F(CheckFaults, OfAMisspeltCreateDoNotHideAbsentBlocks) {
  EXPECT_THAT(faults_of(preliminary() + "CLOOP, 3, 2, 0\nCREAT, 4, 1\n0, 0, 1, 1\n"
                                        "0, 1, 1, 0\nFIX, 3\nFIX, 4\n"),
              AllOf(HasSubstr("FIX: there is no block 4"), HasSubstr("2 errors")));
}

// A faulty CREATE makes at most one block.
TEST_F(CheckFaults, OfAFaultyCreateHideOnlyItsOwnBlock) {
  EXPECT_THAT(faults_of(preliminary() + square + "CREATE, 4, 1\n0, 0, 1\n0, 1, 1, 0\n" +
                        of_material_7 + "FIX, 3\nFIX, 4\nPRESSBC, 2, 9, 1, 1\n"),
              AllOf(HasSubstr("FIX: there is no block 4"),
                    HasSubstr("at most 3 blocks exist here"),
                    HasSubstr("expected 4 x coordinates"), HasSubstr("no material 7"),
                    HasSubstr("no FUNCTION"), HasSubstr("4 errors")));
}

// Block 1 comes before the faulty card, so it certainly is block 1; block 2 may not be.
TEST_F(CheckFaults, OfAFaultyCreateHideNoFaultOfTheBlocksBefore) {
  const std::string faults =
      faults_of(preliminary("RIGID\nFUNCTION, 1\n0, 1\n") + square +
                "CREATE, 4, 1\n2, 2, 3\n0, 1, 1, 0\n" + rectangle(5, 5, 6, 6) +
                "PRESSBC, 1, 9, 1, 1\nPRESSBC, 2, 9, 1, 1\n");
  EXPECT_THAT(faults, AllOf(HasSubstr("PRESSBC: there is no side 9\n"),
                            HasSubstr("hint: block 1 has sides 1 to 4\n"),
                            HasSubstr("2 errors")));
}

// A faulty CREATE counts as a block, so the numbers of the blocks behind it are sure.
TEST_F(CheckFaults, OfAFaultyCreateHideNoFaultOfTheBlocksBehind) {
  for (const char* faulty : {"CREATE, 4, 1\n2, 2, 3, 3\n0, 1, 0, 1\n",  // crossing
                             "CREATE, 4, 1\n2, 2, 3, x\n0, 1, 1, 0\n",
                             "CREATE, 4, 7\n2, 2, 3, 3\n0, 1, 1, 0\n",
                             "CREATE, 4, 1\n2, 2, 3\n0, 1, 1, 0\n"})
    EXPECT_THAT(faults_of(preliminary("RIGID\nFUNCTION, 1\n0, 1\n") + square + faulty +
                          rectangle(5, 5, 6, 6) +
                          "PRESSBC, 3, 9, 1, 1\nPRESSBC, 2, 9, 1, 1\n"
                          "PRESSBC, 1, 7, 1, 1\nFIX, 4\n"
                          "HISTORY, .1, x:2.9, x:3.8\n"),
                AllOf(HasSubstr("PRESSBC: there is no side 9\n"),
                      HasSubstr("hint: block 3 has sides 1 to 4\n"),
                      HasSubstr("PRESSBC: there is no side 7\n"),
                      HasSubstr("FIX: there is no block 4\n"),
                      HasSubstr("HISTORY: block 3 has no corner 8\n"),
                      HasSubstr("5 errors")));
}

TEST_F(CheckFaults, OfCopiesAreCountedToo) {
  EXPECT_THAT(faults_of(preliminary() +
                        "CLOOP, 3, 2, 0\nCREATE, 4, 1\n0, 0, 1, 1\n"
                        "0, 1, 0, 1\n" +
                        rectangle(7, 7, 8, 8) + "DRIVE, 4, 1, 0\nDRIVE, 3, 1, 0\n"),
              AllOf(HasSubstr("DRIVE: block 4 is not fixed"), HasSubstr("2 errors")));
}

// The number of blocks in the mesh is unknown, so the block behind it has no sure
// number, and its faults are not reported.
TEST_F(CheckFaults, OfAnAbsentMeshHideTheBlocksBehind) {
  EXPECT_THAT(faults_of(preliminary() + square + "READ9, absent.msh\n" +
                        rectangle(5, 5, 6, 6) + "DRIVE, 2, 1, 0\nDRIVE, 1, 1, 0\n"),
              AllOf(HasSubstr("READ9"), HasSubstr("DRIVE: block 1 is not fixed"),
                    HasSubstr("2 errors")));
}

TEST_F(CheckFaults, CountOneBlockInTheSingular) {
  EXPECT_THAT(faults_of(preliminary() + "CREATE, 4, 1\n2, 2, 3\n0, 1, 1, 0\nFIX, 2\n"),
              HasSubstr("at most 1 block exists here"));
}

TEST_F(CheckFaults, OfAFaultyMaterialHideOnlyItsOwnNumber) {
  EXPECT_THAT(faults_of(preliminary("RIGID\nMATERIAL, 7, , , heavy\n") + of_material_7 +
                        "SETVELM, 7, 1, 1\nSETVELM, 8, 1, 1\n"),
              AllOf(HasSubstr("found 'heavy'"), HasSubstr("no material 8"),
                    HasSubstr("2 errors")));
}

TEST_F(CheckFaults, OfAMissingMaterialHaveNoConsequences) {
  EXPECT_THAT(
      faults_of("START, 9, 9\nTITLE\nXLIMITS, 0, 9\nYLIMITS, 0, 9\nBOXES, 1, 1\n"
                "FRACTION, .1\nRIGID\nEND\n" +
                square + "FIX, 1\nSETVELM, 1, 1, 1\nFIX, 9\n"),
      AllOf(HasSubstr("MATERIAL: required card missing"), HasSubstr("no block 9"),
            HasSubstr("2 errors")));
}

TEST_F(CheckFaults, BehindARestartAreReportedWithMisspeltCards) {
  run_text(folder_, "first", preliminary() + square + "CYCLE, 2\n");
  EXPECT_THAT(faults_of("RESTART, first.ckpt.h5\nGRAVTY, 0, 1\nFIX, 1\nFIX, 9\n" +
                        of_material_7),
              AllOf(HasSubstr("GRAVTY"), HasSubstr("there is no block 9"),
                    HasSubstr("there is no material 7"), HasSubstr("3 errors")));
}

// Nothing is known about the blocks, materials and functions of the checkpoint.
TEST_F(CheckFaults, BehindAnAbsentCheckpointAreReportedIfTheyDoNotDependOnIt) {
  EXPECT_THAT(faults_of("RESTART, absent.h5\nFIX, 1\nFORCE, 1, 1, 1\n" + of_material_7 +
                        "CREATE, 4, 1\n0, 1, 0, 1\n0, 1, 1, 0\nGRAVITY, up\n"),
              AllOf(HasSubstr("RESTART: "), HasSubstr("CREATE: "),
                    HasSubstr("GRAVITY: "), HasSubstr("3 errors")));
}

// No checkpoint can belong to a faulty deck that starts a run.
TEST_F(CheckFaults, AreReportedBeforeTheCheckpointIsRead) {
  EXPECT_THAT(faults_of(preliminary() + square + "GRAVTY, 0, 1\nFIX, 9\n",
                        "--restart absent.h5"),
              AllOf(HasSubstr("GRAVTY"), HasSubstr("no block 9"), HasSubstr("2 errors"),
                    Not(HasSubstr("absent.h5"))));
}

// Planes and the time step do not depend on the fault of another card.
TEST_F(CheckFaults, DoNotHideThoseOfPlanesAndOfTheStep) {
  EXPECT_THAT(
      faults_of(preliminary() + square + "SPLANE, 5, 0, 5, -5\nFIX, 9\nCYCLE, 1\n"),
      AllOf(HasSubstr("no block 9"),
            HasSubstr("all blocks are on the wrong side of the plane"),
            HasSubstr("2 errors")));
  std::string coarse = preliminary() + square + square + "FRICTN, -1\nCYCLE, 1\n";
  coarse.replace(coarse.find("FRACTION, 0.02"), 14, "FRACTION, 0.9");
  EXPECT_THAT(faults_of(coarse),
              AllOf(HasSubstr("fric must be >= 0"), HasSubstr("FRACTION 0.9"),
                    HasSubstr("2 errors")));
}

}  // namespace
}  // namespace blocks::testing
