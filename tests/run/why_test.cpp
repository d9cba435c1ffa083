// `blocks why` explains a contact, or why there is none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

/// Blocks 1 and 2 are the floor. Block 3 rests on both, block 4 falls, and block 5 is
/// fixed on the floor.
const std::string scene = preliminary() + rectangle(-4, -1, 0, 0, true) +
                          rectangle(0, -1, 4, 0, true) + rectangle(-1, 0, 1, 1) +
                          rectangle(-1, 5, 1, 6) + rectangle(2, 0, 3, 1, true) +
                          "GRAVITY, 0, -10\nDAMPING, 0.3\nPLOTS, 0.1\n";

class Why : public ::testing::Test {
 protected:
  Why() { run_text(folder, "scene", scene + "MOTION, 0.4\nSTOP\n"); }
  Outcome why(const std::string& arguments) const {
    return blocks("why " + arguments, folder.path());
  }
  /// Requires a usage error with this message and hint.
  void expect_refusal(const std::string& arguments, const std::string& fault,
                      const std::string& hint) const {
    const Outcome answer = why(arguments);
    EXPECT_EQ(answer.code, 2) << arguments;
    EXPECT_EQ(answer.out, "");
    EXPECT_THAT(answer.err, HasSubstr("blocks: error: " + fault));
    EXPECT_THAT(answer.err, HasSubstr("hint: " + hint));
  }
  TemporaryFolder folder;
};

TEST_F(Why, ExplainsTheChoiceOfTheContacts) {
  const Outcome answer = why("scene.vtkhdf --block 3 --block 1");
  ASSERT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("scene.vtkhdf: frame 5 of 5, time 0.4"));
  EXPECT_THAT(answer.out, HasSubstr("block 1 (fixed, 4 corners) and block 3"));
  EXPECT_THAT(answer.out, HasSubstr("they overlap by "));
  EXPECT_THAT(answer.out, HasSubstr("their deepest contact is "));
  EXPECT_THAT(answer.out, HasSubstr("blocks 1 and 3: "));
  EXPECT_THAT(answer.out, HasSubstr("corner 1 of block 3 on edge 2 of block 1"));
  EXPECT_THAT(answer.out, HasSubstr("axis of edge 2 of block 1: "));
  EXPECT_THAT(answer.out, HasSubstr("    acts\n"));
  EXPECT_THAT(answer.out, HasSubstr(" deeper axes are not needed"));
  EXPECT_THAT(answer.out, HasSubstr(" deep: foot beyond the end\n"));
  EXPECT_THAT(answer.out, HasSubstr("in the file: corner 1 of block 3 on edge 2 of "
                                    "block 1 acted in the step before:\n"
                                    "    normal force "));
  std::istringstream lines(answer.out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 100U) << line;
}

TEST_F(Why, GivesTheSameAnswerForResultsAndCheckpoint) {
  const Outcome results = why("scene.vtkhdf --block 3 --block 1 --json");
  const Outcome checkpoint = why("scene.ckpt.h5 --block 3 --block 1 --json");
  ASSERT_EQ(results.code, 0) << results.err;
  ASSERT_EQ(checkpoint.code, 0) << checkpoint.err;
  Json one = Json::parse(results.out), other = Json::parse(checkpoint.out);
  EXPECT_FALSE(one["contacts"].empty());
  EXPECT_EQ(one["contacts"].size(), one["step_before"].size());
  EXPECT_NEAR(one["overlap"]["depth"].get<double>(),
              one["overlap"]["deepest_contact"].get<double>(), 1e-15);
  for (const char* own : {"file", "frame"})
    one.erase(own), other.erase(own);
  EXPECT_EQ(one, other);
}

TEST_F(Why, TakesTheNearestFrameAndSaysSo) {
  const Outcome answer = why("scene.vtkhdf --time 0.17 --block 3 --block 2");
  ASSERT_EQ(answer.code, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("frame 3 of 5, time 0.2"));
  EXPECT_THAT(answer.out, HasSubstr("the nearest to 0.17"));
}

TEST_F(Why, ExplainsWhyThereIsNoContact) {
  const Outcome start = why("scene.vtkhdf --time 0 --block 3 --block 2");
  EXPECT_THAT(start.out, HasSubstr("they do not overlap"));
  EXPECT_THAT(start.out, HasSubstr("blocks 2 and 3: no contact"));
  EXPECT_THAT(start.out, HasSubstr("not deeper than zero, so the side separates"));
  EXPECT_THAT(start.out, HasSubstr(" deep: outside\n"));
}

TEST_F(Why, NamesTheChoicesIfAnOptionIsWrong) {
  expect_refusal("scene.vtkhdf --time 9 --block 3 --block 1",
                 "time 9 is outside of scene.vtkhdf",
                 "it holds 5 frames from time 0 to 0.4: 0, 0.1, 0.2, 0.3, 0.4");
  expect_refusal("scene.vtkhdf --time nan --block 3 --block 1", "'nan' is not a time",
                 "it holds");
  expect_refusal("scene.ckpt.h5 --time 0 --block 3 --block 1", "time 0 is outside of",
                 "it holds the state at time 0.4 only");
  expect_refusal("scene.vtkhdf --block 3 --block 6", "there is no block 6",
                 "its blocks are 1 to 5");
  expect_refusal("scene.vtkhdf --block 0 --block 1", "there is no block 0",
                 "its blocks are 1 to 5");
  expect_refusal(
      "scene.vtkhdf --block 3 --block 4",
      "blocks 3 and 4 are not near each other at time 0.4",
      "near block 3: 1 (in contact), 2 (in contact); no block is near block 4");
  expect_refusal("scene.vtkhdf --block 1 --block 5", "blocks 1 and 5 are both fixed",
                 "near block 1: 3 (in contact); no block is near block 5");
  expect_refusal("scene.vtkhdf --block a --block 1",
                 "'a' is not the number of a block of scene.vtkhdf",
                 "its blocks are 1 to 5");
  expect_refusal("scene.vtkhdf --block 3.5 --block 1", "'3.5' is not the number",
                 "its blocks are 1 to 5");
  expect_refusal("scene.vtkhdf --block 3 --block 1 --time late", "'late' is not a time",
                 "it holds 5 frames from time 0 to 0.4");
  expect_refusal("scene.vtkhdf --block 3", "a contact has two blocks",
                 "near block 3: 1 (in contact), 2 (in contact)");
  expect_refusal("scene.vtkhdf", "a contact has two blocks",
                 "the blocks of scene.vtkhdf are 1 to 5");
}

// A block in a long row of blocks has many neighbours.
TEST_F(Why, BreaksLongHints) {
  std::string row = rectangle(-9, -1, 9, 0, true);
  for (int i = 0; i < 30; ++i)
    row += rectangle(-8 + 0.5 * i, 0, -7.5 + 0.5 * i, 0.5);
  run_text(folder, "row", preliminary() + row + "GRAVITY, 0, -9.81\nCYCLE, 3\nSTOP\n");
  const Outcome one = why("row.vtkhdf --block 1");
  EXPECT_THAT(one.err, HasSubstr("\n  hint: near block 1: 2 (in contact), 3 (in"));
  EXPECT_THAT(one.err, HasSubstr("\n        "));
  const Outcome far = why("row.vtkhdf --block 2 --block 31");
  EXPECT_THAT(far.err, HasSubstr("\n  hint: near block 2: 1 (in contact), 3"));
  EXPECT_THAT(far.err,
              HasSubstr("\n        their bounding boxes are more than 0.05 apart\n"));
  std::istringstream lines(one.err + far.err);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 100U) << line;
}

// Block 6 is created at time 0.4.
TEST_F(Why, SaysWhenABlockIsCreated) {
  run_text(folder, "later",
           scene + "MOTION, 0.4\n" + rectangle(-3, 0, -2, 1) + "MOTION, 0.2\nSTOP\n");
  expect_refusal("later.vtkhdf --time 0.1 --block 6 --block 1",
                 "there is no block 6 in later.vtkhdf at time 0.1",
                 "it exists from time 0.5 on; before that, its blocks are 1 to 5");
  expect_refusal("later.vtkhdf --time 0.1 --block 7 --block 1", "there is no block 7",
                 "its blocks are 1 to 5");
  EXPECT_EQ(why("later.vtkhdf --time 0.5 --block 6 --block 1").code, 0);
  EXPECT_EQ(why("later.ckpt.h5 --block 6 --block 1").code, 0);
}

TEST_F(Why, RefusesFilesThatAreNoResults) {
  for (const char* file : {"scene.deck", "scene.out", "nowhere.vtkhdf"}) {
    const Outcome answer = why(std::string(file) + " --block 1 --block 2");
    EXPECT_EQ(answer.code, 5) << file;
    EXPECT_THAT(answer.err, HasSubstr(std::string("cannot read ") + file));
  }
}

}  // namespace
}  // namespace blocks::testing
