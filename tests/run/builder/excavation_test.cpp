// REMOVE and FREE as users see them: messages, results, listing, exports and restarts.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A floor, blocks 2 and 3 in a pile, and block 4 beside it.
const std::string pile = preliminary() + rectangle(-2, -1, 6, 0, true) +
                         rectangle(0, 0, 1, 1) + rectangle(0, 1, 1, 2) +
                         rectangle(3, 0, 4, 1) +
                         "GRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.3\n"
                         "PLOTS, 0.02\nOUTPUT, 0.04\n";
const std::string staged = pile + "MOTION, 0.04\nREMOVE, 2\nMOTION, 0.04\n";

class Excavation : public ::testing::Test {
 protected:
  /// Returns the output of `blocks check` for these cards after the pile.
  Outcome check(const std::string& cards) {
    folder_.write("pile.deck", pile + cards);
    return blocks("check pile.deck", folder_.path());
  }
  TemporaryFolder folder_;
};

TEST_F(Excavation, CheckCountsAndNamesRemovedAndFreedBlocks) {
  const Outcome told = check("FIX, 4\nREMOVE, 2, 3\nFREE, 4\nMOTION, 0.1\n");
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("2 blocks (1 fixed; 2 others removed), 8 corners, "
                                  "area 9\n"));
  EXPECT_THAT(told.out, HasSubstr("REMOVE in line 30 at time 0: 2 blocks removed: 2 to "
                                  "3\n"));
  EXPECT_THAT(told.out, HasSubstr("FREE in line 31 at time 0: 1 block freed: 4\n"));
  EXPECT_THAT(told.out, HasSubstr("no two of 2 blocks overlap"));
}

TEST_F(Excavation, CheckCountsOneBlockInTheSingular) {
  const Outcome told = check("REMOVE, 2, 4\nMOTION, 0.1\n");
  EXPECT_THAT(told.out, HasSubstr("1 block (1 fixed; 3 others removed), 4 corners"));
  EXPECT_THAT(told.out, HasSubstr("\n1 block, so none overlap\n"));
  EXPECT_THAT(check("REMOVE, 4\nMOTION, 0.1\n").out, HasSubstr("; 1 other removed)"));
  const Outcome run =
      run_text(folder_, "one", preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 1\n");
  EXPECT_THAT(run.err, HasSubstr("(contact), 1 block, seed "));
  EXPECT_THAT(run.err, HasSubstr("done after 1 step, t "));
}

TEST_F(Excavation, WarnsIfNothingIsRemoved) {
  EXPECT_THAT(check("REMOVE, 2\nREMOVE, 2\nMOTION, 0.1\n").err,
              HasSubstr("pile.deck:30:1: warning: REMOVE: the blocks named here are "
                        "removed already\n"));
  EXPECT_THAT(check("REMOVE, , , 2\nMOTION, 0.1\n").err,
              HasSubstr("warning: REMOVE: no block of material 2 exists here\n"));
  const std::string inside = check("REMOVE, , , , 4\n-0.1, 0.9, 0.9, -0.1\n"
                                   "-0.1, -0.1, 2.1, 2.1\nMOTION, 0.1\n")
                                 .err;
  EXPECT_THAT(inside, HasSubstr("pile.deck:29:15: warning: REMOVE: no block lies "
                                "entirely inside the outline\n"));
  EXPECT_THAT(inside, HasSubstr("2 blocks with the centroid inside reach beyond the "
                                "outline: draw it wider"));
}

// Cards behind a motion do not change the blocks before the first step.
TEST_F(Excavation, CheckAndExportShowTheBlocksBeforeTheFirstStep) {
  const Outcome told = check("MOTION, 0.1\nREMOVE, 2, 3\nMOTION, 0.1\n");
  EXPECT_THAT(told.out, HasSubstr("4 blocks (1 fixed), 16 corners, area 11\n"));
  EXPECT_THAT(told.out,
              HasSubstr("REMOVE in line 30, if nothing moves before: 2 blocks "
                        "removed: 2 to 3\n"));
  EXPECT_THAT(blocks("export pile.deck -o pile.wkt", folder_.path()).out,
              HasSubstr("4 blocks"));
}

// FIX and FREE behind a motion change neither the number of fixed blocks nor the time
// step of the start. Block 3 is stiff, so it sets the time step when it is free.
TEST_F(Excavation, CheckDescribesTheStateAtTheFirstMotion) {
  std::string deck = preliminary("") + rectangle(-2, -1, 6, 0, true) +
                     rectangle(0, 0, 1, 1) + "CREATE, 4, 3\n3, 3, 4, 4\n0, 1, 1, 0\n";
  deck.insert(deck.find("END"), "MATERIAL, 3, 1.E13, 4.E12, 1000\n");
  for (const std::string& rest :
       {std::string(), std::string("FREE, 3\nFREE, 1\nFIX, 2\nCYCLE, 1\n")}) {
    folder_.write("s.deck", deck + "FIX, 3\nCYCLE, 1\n" + rest);
    const Outcome told = blocks("check s.deck", folder_.path());
    EXPECT_THAT(told.out, HasSubstr("3 blocks (2 fixed), 12 corners")) << told.err;
    EXPECT_THAT(told.out, HasSubstr("time step 0.0004, set by block 2 (contact)\n"));
  }
}

TEST_F(Excavation, CheckCountsLaterBlocksApart) {
  const Outcome told = check("MOTION, 0.1\n" + rectangle(3, 0, 4, 1) + "MOTION, 0.1\n");
  EXPECT_THAT(told.out, HasSubstr("4 blocks (1 fixed), 16 corners, area 11\n"));
  EXPECT_THAT(told.out,
              HasSubstr("blocks made after the first MOTION, CYCLE or SOLVE: 1; the "
                        "run checks them for overlaps\n"));
}

// Before the motion the check does not know where blocks will be.
TEST_F(Excavation, CheckDoesNotJudgeLaterOutlines) {
  const std::string later = "MOTION, 0.1\nREMOVE, , , , 4\n5, 6, 6, 5\n5, 5, 6, 6\n"
                            "MOTION, 0.1\n";
  EXPECT_THAT(check(later).err, Not(HasSubstr("warning")));
  EXPECT_THAT(run_text(folder_, "later", pile + later).err,
              HasSubstr("later.deck:30:15: warning: REMOVE: no block lies entirely "
                        "inside the outline\n"));
}

TEST_F(Excavation, RefusesAnOutlineThatCrossesItself) {
  const Outcome told = check("REMOVE, , , , 4\n0, 1, 0, 1\n0, 0, 1, 1\nMOTION, 0.1\n");
  EXPECT_EQ(told.code, 3);
  EXPECT_THAT(told.err, HasSubstr("pile.deck:30:4: error: REMOVE: the outline is not a "
                                  "simple polygon: sides 2 and 4 cross\n"));
}

TEST_F(Excavation, WarnsOfCardsThatChangeARemovedBlock) {
  const std::string told =
      check("REMOVE, 2, 3\nFIX, 2\nFREE, 2, 3\nSETVEL, 2, 3, 1, 0\nMOTION, 0.1\n").err;
  EXPECT_THAT(told, HasSubstr("FIX: block 2 is removed, so the card has no effect"));
  EXPECT_THAT(told, HasSubstr("FREE: blocks 2 to 3 are removed and cannot be freed\n"));
  EXPECT_THAT(told, HasSubstr("hint: FREE frees the blocks that FIX or ifix has"));
  EXPECT_THAT(told, HasSubstr("SETVEL: blocks 2 to 3 are removed, so the card has no "
                              "effect\n"));
  EXPECT_THAT(check("REMOVE, 2, 4\nSETVELM, 1, 1, 0\nREMOVE, 1\n" +
                    rectangle(7, 0, 8, 1) + "MOTION, 0.1\n")
                  .err,
              Not(HasSubstr("SETVELM")));
  EXPECT_THAT(check("REMOVE, 1, 4\nSETVELM, 1, 1, 0\n" + rectangle(7, 0, 8, 1) +
                    "MOTION, 0.1\n")
                  .err,
              HasSubstr("SETVELM: blocks 1 to 4 are removed, so the card has no "
                        "effect\n"));
  EXPECT_THAT(check("REMOVE, 2\nSETVEL, 2, 3, 1, 0\nMOTION, 0.1\n").err,
              Not(HasSubstr("SETVEL")));
  EXPECT_THAT(check("FREE, 2\nMOTION, 0.1\n").err,
              HasSubstr("FREE: the blocks named here are free already\n"));
}

// Only the run knows that block 4 leaves the domain.
TEST_F(Excavation, DoesNotFreeABlockThatLeftTheDomain) {
  const std::string cards = "SETVEL, 4, 0, 100, 0\nMOTION, 0.1\nFREE, 4\nCYCLE, 1\n";
  EXPECT_EQ(check(cards).err, "");
  EXPECT_THAT(run_text(folder_, "out", pile + cards).err,
              HasSubstr("FREE: block 4 is outside the domain and cannot be freed\n"));
}

// Blocks 2 to 4 are ever stiffer. The run chooses another time step if block 3 becomes
// free or if block 4, which sets the time step, is removed.
TEST_F(Excavation, RunWarnsIfStiffnessCutsTheNewTimeStep) {
  std::string deck = preliminary("") + rectangle(-2, -1, 6, 0, true);
  deck.insert(deck.find("END"), "MATERIAL, 3, 1.E12, 4.E11, 1000\n"
                                "MATERIAL, 4, 1.E13, 4.E12, 1000\n");
  for (const char* material : {"1", "3", "4"})
    deck +=
        fmt::format("CREATE, 4, {0}\n{0}, {0}, {0}.5, {0}.5\n0, 1, 1, 0\n", material);
  const std::string cut = "CYCLE: the time step is cut to ",
                    by_three = " by the stiffness of block 3\n";
  EXPECT_THAT(
      run_text(folder_, "f", deck + "FIX, 3\nFIX, 4\nCYCLE, 2\nFREE, 3\nCYCLE, 2\n")
          .err,
      AllOf(HasSubstr(cut), HasSubstr(by_three)));
  EXPECT_THAT(run_text(folder_, "r", deck + "CYCLE, 2\nREMOVE, 4\nCYCLE, 2\n").err,
              AllOf(HasSubstr(cut), HasSubstr(by_three)));
  EXPECT_THAT(
      run_text(folder_, "n", deck + "FIX, 3\nCYCLE, 2\nREMOVE, 3\nCYCLE, 2\n").err,
      Not(HasSubstr(by_three)));
}

TEST_F(Excavation, RefusesToMoveNothing) {
  const Outcome all = check("REMOVE, 1, -1\nMOTION, 0.1\n");
  EXPECT_EQ(all.code, 3);
  EXPECT_THAT(all.err, HasSubstr("MOTION: all blocks are removed"));
  const Outcome free = check("REMOVE, 2, -1\nMOTION, 0.1\n");
  EXPECT_EQ(free.code, 0);
  EXPECT_THAT(free.err, HasSubstr("all free blocks are removed, so nothing will move"));
}

// Numbers and materials do not depend on the motion; the blocks in an outline do.
TEST_F(Excavation, RefusesToMoveNothingLater) {
  const std::string all = "REMOVE, , , 1\n", rest = "MOTION, 0.1\n",
                    inside = "REMOVE, , , , 4\n-9, -9, 9, 9\n-9, 9, 9, -9\n";
  const Outcome certain = check(rest + "REMOVE, 2\nMOTION, 0.1\n" + all + rest);
  EXPECT_EQ(certain.code, 3);
  EXPECT_THAT(certain.err, HasSubstr("pile.deck:33:1: error: MOTION: all blocks are "
                                     "removed, so there is nothing to move\n"));
  const Outcome uncertain = check(rest + inside + rest);
  EXPECT_EQ(uncertain.code, 0) << uncertain.err;
  EXPECT_THAT(uncertain.out, HasSubstr("if nothing moves before: 4 blocks removed"));
  EXPECT_EQ(check(rest + inside + all + rest).code, 3);
}

// An outline may contain the place of an earlier one.
TEST_F(Excavation, CheckNamesTheBlocksOfTwoOutlinesOnce) {
  const std::string right = "REMOVE, , , , 4\n2, 2, 5, 5\n0, 3, 3, 0\n",
                    both = "REMOVE, , , , 4\n-1, -1, 5, 5\n0, 3, 3, 0\n";
  const std::string told = check("MOTION, 0.1\n" + right + both + "MOTION, 0.1\n").out;
  EXPECT_THAT(told, HasSubstr("1 block removed: 4\n"));
  EXPECT_THAT(told, HasSubstr("2 blocks removed: 2 to 3\n"));
}

// Block 2 was removed, so a new block may have its place.
TEST_F(Excavation, NewBlocksMayHaveThePlaceOfRemovedOnes) {
  const std::string filled = "REMOVE, 2\n" + rectangle(0, 0, 1, 1) + "MOTION, 0.1\n";
  for (const char* before : {"", "MOTION, 0.1\n"}) {
    const Outcome told = check(before + filled);
    EXPECT_THAT(told.err, Not(HasSubstr("overlap"))) << before;
    EXPECT_THAT(told.out, HasSubstr("no two of 4 blocks overlap")) << before;
  }
}

TEST_F(Excavation, ResultsHaveAnEmptyCell) {
  run_text(folder_, "staged", staged);
  const post::ResultsReader results((folder_ / "staged.vtkhdf").string());
  const post::Frame first = results.frame(0),
                    last = results.frame(results.frames() - 1);
  EXPECT_EQ(first.outlines[1].size(), 4U);
  EXPECT_EQ(last.size(), 4);
  EXPECT_EQ(last.count_present(), 3);
  EXPECT_EQ(last.fixed, (std::vector<int>{1, 3, 0, 0}));
  EXPECT_TRUE(last.outlines[1].empty());
  EXPECT_EQ(last.outlines[2].size(), 4U);
  EXPECT_TRUE(std::isnan(last.velocity(0, 1)));
  EXPECT_EQ(results.last_outlines(results.frames() - 1)[1].size(), 4U);
  EXPECT_GT(first.centroid(1, 2) - last.centroid(1, 2), 0.001);
}

TEST_F(Excavation, ListingAndSummaryNameRemovedBlocks) {
  run_text(folder_, "staged", staged);
  const std::string listing = slurp(folder_ / "staged.out");
  EXPECT_THAT(listing, HasSubstr("1 block removed: 2\n"));
  EXPECT_THAT(listing, HasSubstr("  removed"));
  EXPECT_EQ(summary(folder_, "staged")["removed_blocks"], 1);
  EXPECT_EQ(summary(folder_, "staged")["blocks"], 4);
}

TEST_F(Excavation, HistoryOfARemovedBlockEnds) {
  run_text(folder_, "staged", staged);
  const std::string csv =
      blocks("history staged.vtkhdf -q y:2,blocks,mass --csv", folder_.path()).out;
  EXPECT_THAT(csv, HasSubstr(",0.5"));
  EXPECT_THAT(csv, HasSubstr(",,3,10000\n"));
}

TEST_F(Excavation, WhyTellsWhenABlockWasRemoved) {
  run_text(folder_, "staged", staged);
  const Outcome why = blocks("why staged.vtkhdf -b 2 -b 3", folder_.path());
  EXPECT_EQ(why.code, 2);
  EXPECT_THAT(why.err, HasSubstr("block 2 is removed at time 0.08"));
  EXPECT_THAT(why.err, HasSubstr("it was removed between times 0.04 and 0.06"));
  run_text(folder_, "at_once", pile + "REMOVE, 2\nMOTION, 0.04\n");
  EXPECT_THAT(blocks("why at_once.vtkhdf -b 2 -b 3", folder_.path()).err,
              HasSubstr("it was removed at time 0 or before"));
  EXPECT_EQ(blocks("why staged.vtkhdf -b 1 -b 4", folder_.path()).code, 0);
  EXPECT_EQ(blocks("why staged.ckpt.h5 -b 1 -b 4", folder_.path()).code, 0);
  EXPECT_THAT(blocks("why staged.ckpt.h5 -b 2 -b 4", folder_.path()).err,
              HasSubstr("block 2 is removed"));
}

TEST_F(Excavation, ExportsLeaveRemovedBlocksOut) {
  run_text(folder_, "staged", staged);
  const Outcome told = blocks("export staged.vtkhdf -o s.geojson", folder_.path());
  EXPECT_THAT(told.out, HasSubstr("3 blocks at time 0.08; 1 removed block left out"));
  EXPECT_THAT(slurp(folder_ / "s.geojson"), Not(HasSubstr("\"number\": 2,")));
  folder_.write("d.deck", pile + "REMOVE, 2\nMOTION, 0.1\n");
  EXPECT_THAT(blocks("export d.deck -o d.wkt", folder_.path()).out,
              HasSubstr("3 blocks"));
}

TEST_F(Excavation, FiguresAndPagesShowTheOthers) {
  run_text(folder_, "staged", staged);
  for (const char* more :
       {"", "--colour displacement --arrows velocity --numbers", "--forces --original"})
    EXPECT_EQ(
        blocks(fmt::format("plot staged.vtkhdf -o s.svg {}", more), folder_.path())
            .code,
        0)
        << more;
  EXPECT_EQ(blocks("plot staged.vtkhdf -o n.svg --numbers", folder_.path()).code, 0);
  EXPECT_THAT(slurp(folder_ / "n.svg"), HasSubstr("3 blocks"));
  EXPECT_THAT(slurp(folder_ / "n.svg"), Not(HasSubstr("paint-order=\"stroke\">2<")));
  EXPECT_EQ(blocks("view staged.vtkhdf -o s.html", folder_.path()).code, 0);
  EXPECT_THAT(slurp(folder_ / "s.html"), HasSubstr("\"present\":[4,4,4,3,3]"));
}

// A RESTART deck may go on digging, with the bits of one deck.
TEST_F(Excavation, RestartDeckGivesTheBitsOfOneDeck) {
  const std::string second = "REMOVE, 2\nCYCLE, 100\n", third = "FREE, 1\nCYCLE, 50\n";
  run_text(folder_, "whole", pile + "CYCLE, 100\n" + second + third);
  run_text(folder_, "first", pile + "CYCLE, 100\n" + second);
  run_text(folder_, "second", "RESTART, first.ckpt.h5\n" + third);
  EXPECT_EQ(summary(folder_, "second")["state_hash"],
            summary(folder_, "whole")["state_hash"]);
  run_text(folder_, "zero", pile + "CYCLE, 100\n");
  run_text(folder_, "again", "RESTART, zero.ckpt.h5\n" + second + third);
  EXPECT_EQ(summary(folder_, "again")["state_hash"],
            summary(folder_, "whole")["state_hash"]);
}

// The deck ends with REMOVE of the block that set the time step.
TEST_F(Excavation, CheckpointBehindARemovalCanBeContinued) {
  run_text(folder_, "end", wall_at_random() + "CYCLE, 2\nREMOVE, 2, 100\n");
  const Outcome on = run_text(folder_, "on", "RESTART, end.ckpt.h5\nCYCLE, 2\n");
  EXPECT_EQ(on.code, 0) << on.err;
  EXPECT_EQ(summary(folder_, "on")["removed_blocks"], 99);
}

TEST_F(Excavation, AuditFindsNoFault) {
  run_text(folder_, "staged", staged, "--audit=10");
  const auto json = summary(folder_, "staged");
  EXPECT_EQ(json["audit"]["faults"], nlohmann::json::array());
  EXPECT_EQ(json["audit"]["excess_pairs"], 0);
  EXPECT_GT(json["audit"]["moments"].get<int>(), 10);
}

}  // namespace
}  // namespace blocks::testing
