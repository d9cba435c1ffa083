// Selectors in cards: what they select, what the cards do with it, and the messages.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/run.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Unit squares in two rows of three, block 4 above block 1; the last is of material 2.
std::string wall() {
  std::string cards = preliminary();
  cards.insert(cards.find("END"), "FUNCTION, 2\n0, 1\n1, 1\n");
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < 3; ++i)
      cards += rectangle(i, row, i + 1, row + 1);
  return cards;
}

/// A square of side 10 cut by vertical joints of id 3, spacing 2, through the origin.
std::string cut_square() {
  std::string cards = preliminary();
  cards.replace(0, cards.find('\n'), "START, 500, 50");
  cards.insert(cards.find("END"), "FUNCTION, 2\n0, 1\n1, 1\n");
  return cards + "OUTLINE, 4, 1\n-5, -5, 5, 5\n-5, 5, 5, -5\n"
                 "JSET, 3, 90, 0, 2, 0, 0, 0, 0, 0, 0, 0\nCUT\n";
}

class SelectorCards : public ::testing::Test {
 protected:
  Outcome check(const std::string& deck) {
    folder_.write("t.deck", deck);
    return blocks("check t.deck", folder_.path());
  }
  /// Returns the model before its first motion. The deck must be sound.
  Model model_of(const std::string& deck) {
    folder_.write("t.deck", deck + "CYCLE, 1\n");
    run::RunOptions options;
    options.deck = (folder_ / "t.deck").string();
    options.quiet = true;
    ::testing::internal::CaptureStderr();
    run::CheckedDeck checked = run::build_checked(options);
    const std::string messages = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(checked.code, 0) << messages;
    return std::move(checked.model);
  }
  TemporaryFolder folder_;
};

// Each card does the same as with the numbers.
TEST_F(SelectorCards, ActLikeTheNumbers) {
  const Model a =
      model_of(wall() + "FIX, at(.5, .5)\nFIX, in(1, 1, 3, 2)\n"
                        "FREE, at(2.5, 1.5)\nSETVEL, at(1.5, .5), , 1, 2, 3\n"
                        "FORCE, at(2.5, .5), 4\nDRIVE, at(1.5, 1.5), 1\n"
                        "OUTPUT, 1, 2, in(0, 1, 9, 9), 1\n");
  const Model b = model_of(wall() + "FIX, 1\nFIX, 5\nFIX, 6\nFREE, 6\n"
                                    "SETVEL, 2, , 1, 2, 3\nFORCE, 3, 4\nDRIVE, 5, 1\n"
                                    "OUTPUT, 1, 2, 4, 5, 6, 1\n");
  EXPECT_EQ(a.blocks.fixity, b.blocks.fixity);
  EXPECT_EQ(a.blocks.velocity, b.blocks.velocity);
  EXPECT_EQ(a.blocks.spin, b.blocks.spin);
  ASSERT_EQ(a.loads.forces.size(), 1U);
  EXPECT_EQ(a.loads.forces[0].block, 2);
  EXPECT_EQ(a.output_blocks, b.output_blocks);
  EXPECT_EQ(b.blocks.fixity[0], Fixity::by_user);
  EXPECT_EQ(b.blocks.fixity[4], Fixity::driven);
}

TEST_F(SelectorCards, CheckTellsWhatIsSelected) {
  const Outcome told =
      check(wall() + "FIX, at(.5, .5)\nSETVEL, material(1), , 1\n"
                     "REMOVE, in(1, 1, 3, 2)\nPRESSBC, , on(0, 0, 3, 0), 1, 1\n"
                     "HISTORY, .1, y:at(1.5, .5), y:in(0 0 3 2):max, x:nearest(3, 0)\n"
                     "CYCLE, 1\n");
  EXPECT_EQ(told.code, 0) << told.err;
  for (const char* note :
       {"FIX in line 33 at time 0: at(.5, .5) selects block 1\n",
        "SETVEL in line 34 at time 0: material(1) selects 6 blocks: 1 to 6\n",
        "REMOVE in line 35 at time 0: 2 blocks removed: 5 to 6\n",
        "PRESSBC in line 36 at time 0: on(0, 0, 3, 0) selects 3 sides of blocks 1 to "
        "3\n",
        "HISTORY in line 37 at time 0: y:at(1.5, .5) is y:2\n",
        "HISTORY in line 37 at time 0: y:in(0 0 3 2):max is y:1-4:max\n",
        "HISTORY in line 37 at time 0: x:nearest(3, 0) is x:3.4\n"})
    EXPECT_THAT(told.out, HasSubstr(note));
}

// The numbers of a box need not be consecutive.
TEST_F(SelectorCards, HistoryHasBlocksWithGaps) {
  const Model model = model_of(wall() + "HISTORY, .1, y:in(1, 0, 3, 2), contacts\n");
  EXPECT_THAT(model.history.quantities, ElementsAre("y:2-3/5-6", "contacts"));
}

TEST_F(SelectorCards, HistoryOfABoxIsThatOfItsBlocks) {
  const std::string deck = wall() +
                           "GRAVITY, 0, -9.8\nSETVEL, 5, , 0, 3\n"
                           "HISTORY, .001, y:in(1, 0, 3, 2), y:2, y:3, y:5, y:6, "
                           "unbalanced:at(.5, .5)\nMOTION, .004\n";
  run_text(folder_, "box", deck);
  const Outcome shown = blocks("history box.vtkhdf", folder_.path());
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("y:2-3/5-6"));
}

// Rock that has settled is no longer exactly on the edge of its outline.
TEST_F(SelectorCards, AnEdgeIsFoundAfterBlocksHaveMoved) {
  const Outcome run = run_text(folder_, "a",
                               cut_square() + rectangle(-9, -6, 9, -5, true) +
                                   "GRAVITY, 0, -9.81\nFRICTN, .5\nLOCDAMP, .8\nSOLVE\n"
                                   "PRESSBC, , edge(2), 1.E4, 1.E4\nPRESSBC, , on(-5, "
                                   "5, 5, 5), 1, 1\nCYCLE, 1\n");
  EXPECT_EQ(run.code, 0) << run.err;
}

// Side 2 of a block of CREATE is its top. The pressure along an edge is that of the
// points of the edge: here 0 at x = -5 and 10 at x = 5.
TEST_F(SelectorCards, PressureIsLinearAlongAnEdge) {
  const Model model = model_of(cut_square() + "PRESSBC, , edge(2), 0, 10\n");
  ASSERT_EQ(model.loads.pressures.size(), 6U);
  const Blocks& blocks = model.blocks;
  double force = 0.0;
  for (const auto& load : model.loads.pressures) {
    const int c = blocks.first_corner[load.block] + load.side;
    EXPECT_EQ(blocks.corner(1, c), 5.0);
    EXPECT_EQ(blocks.corner(1, blocks.next[c]), 5.0);
    EXPECT_NEAR(load.p1, blocks.corner(0, c) + 5.0, 1e-12);
    EXPECT_NEAR(load.p2, blocks.corner(0, blocks.next[c]) + 5.0, 1e-12);
    force += 0.5 * (load.p1 + load.p2) *
             (blocks.corner(0, blocks.next[c]) - blocks.corner(0, c));
  }
  EXPECT_NEAR(force, 50.0, 1e-12);
}

// Edge 4 runs against x if the outline is clockwise; both faces of a joint have its id.
TEST_F(SelectorCards, SidesAreThoseOfTheEdgeOrTheJoint) {
  const Model model =
      model_of(cut_square() + "FIX, in(-9, -9, 9, 9)\nPRESSBC, , edge(4), 1, 1\n"
                              "PRESSBC, at(0.5, 0), joint(3), 2, 2\n");
  ASSERT_EQ(model.loads.pressures.size(), 8U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(model.blocks.corner(1, model.blocks.first_corner[static_cast<int>(
                                         model.loads.pressures[i].block)] +
                                         model.loads.pressures[i].side),
              -5.0);
  EXPECT_EQ(model.loads.pressures[6].block, model.loads.pressures[7].block);
}

TEST_F(SelectorCards, RefusesWhatSelectsNothingOrTooMuch) {
  const std::pair<const char*, const char*> faults[] = {
      {"FIX, at(7, 7)", "t.deck:33:6: error: FIX: at(7, 7) selects no block\n"
                        "  FIX, at(7, 7)\n       ^~~~~~~~\n"
                        "  hint: the nearest corner is that of block 6 at (3, 2)\n"},
      {"FIX, in(0, 0, .1, .1)", "FIX: in(0, 0, .1, .1) selects no block\n"},
      {"FIX, material(2)", "FIX: material(2) selects no block\n"},
      {"FIX, material(3)", "FIX: there is no material 3\n"},
      {"PRESSBC, , joint(5), 1, 1", "PRESSBC: joint(5) selects no side\n"},
      {"PRESSBC, , edge(1), 1, 1", "PRESSBC: no OUTLINE above has edges\n"},
      {"FORCE, in(0, 0, 3, 1), 1",
       "t.deck:33:8: error: FORCE: in(0, 0, 3, 1) selects 3 blocks, and the card takes "
       "one\n"},
      {"DRIVE, in(0, 0, 3, 1), 1, 0, 1", "DRIVE: in(0, 0, 3, 1) selects 3 blocks"},
      {"SERVO, , on(0, 0, 3, 0), 1, 1", "SERVO: on(0, 0, 3, 0) selects 3 sides"},
      {"HISTORY, 1, y:at(7, 7)",
       "t.deck:33:13: error: HISTORY: at(7, 7) selects no block\n"}};
  for (const auto& [card, message] : faults) {
    const Outcome told = check(wall() + card + "\nCYCLE, 1\n");
    EXPECT_EQ(told.code, 3) << card;
    EXPECT_THAT(told.err, HasSubstr(message));
  }
}

// After a motion the check cannot know what a selector selects, and the run can.
TEST_F(SelectorCards, SelectWhereTheBlocksAreInTheRun) {
  const std::string in_motion = wall() + "SETVEL, 6, , 100, 0\nMOTION, .01\n";
  const std::string deck = in_motion + "FIX, at(3.5, 1.5)\nDRIVE, at(3.5, 1.5), 0, 0\n"
                                       "REMOVE, at(.5, .5)\nCYCLE, 1\n";
  EXPECT_EQ(check(deck).code, 0);
  const Outcome run = run_text(folder_, "later", deck);
  EXPECT_THAT(run.err + slurp(folder_ / "later.out"),
              HasSubstr("at(3.5, 1.5) selects block 6"));
  // A selector that selects nothing ends the run there.
  folder_.write("none.deck", in_motion + "FIX, at(8, 8)\nCYCLE, 1\n");
  const Outcome ended = blocks("run none.deck", folder_.path());
  EXPECT_NE(ended.code, 0);
  EXPECT_THAT(ended.err, HasSubstr("FIX: at(8, 8) selects no block\n"));
}

// A dipping layer of two blocks: each knows its bottom, top and sides. Faces of a mesh
// have the ids that the file gives, and others by their direction.
TEST_F(SelectorCards, FacesOfLayersAndMeshesHaveJointIds) {
  const Model layer =
      model_of(preliminary() + "LAYER, -2, 1, 0, 0, -1, 1, 3, 5, 4, 4, , "
                               "7, 8, 9\n");
  EXPECT_EQ(layer.blocks.joint, (std::vector<int>{9, 8, 9, 7, 9, 8, 9, 7}));
  folder_.write("m.txt", "BLOCKS, 1\n5, 1\n0, 0\n0, 2, 3\n1, 3\n2, 2\n2, 0\n");
  const Model mesh = model_of(preliminary() + "READ9, m.txt, 7, 8, 9\n");
  // The slanted sides are at 45 degrees, so they are no tops.
  EXPECT_EQ(mesh.blocks.joint, (std::vector<int>{9, 3, 9, 9, 7}));
}

// With CENTROID the centroid decides, on the outline too.
TEST_F(SelectorCards, RemovesByTheCentroid) {
  const std::string outline = "4, {}\n0, 0, 1.5, 1.5\n0, 9, 9, 0\n";
  const Outcome inside =
      check(wall() + "REMOVE, , , , " + fmt::format(fmt::runtime(outline), "inside") +
            "CYCLE, 1\n");
  EXPECT_THAT(inside.out, HasSubstr("2 blocks removed: 1, 4\n"));
  EXPECT_THAT(inside.err, HasSubstr("2 blocks cross the outline: 2, 5\n"));
  const Outcome centroid =
      check(wall() + "REMOVE, , , , " + fmt::format(fmt::runtime(outline), "centroid") +
            "CYCLE, 1\n");
  EXPECT_THAT(centroid.out, HasSubstr("4 blocks removed: 1 to 2, 4 to 5\n"));
  EXPECT_THAT(centroid.err,
              HasSubstr("REMOVE: 2 blocks cross the outline; removed: 2, 5\n"));
  const Outcome both = check(wall() + "REMOVE, , , , 4, centroid\n.6, .6, 1.5, 1.5\n0, "
                                      "9, 9, 0\nCYCLE, 1\n");
  EXPECT_THAT(both.err, HasSubstr("REMOVE: 4 blocks cross the outline; removed: 2, 5; "
                                  "not removed: 1, 4\n"));
}

}  // namespace
}  // namespace blocks::testing
