// What `blocks check` says of joints that are probably not as they were meant: ends
// that stop just short of another joint, ids that no side has, and joints that nearly
// coincide.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class DoubtfulJoints : public ::testing::Test {
 protected:
  /// Checks a square of 10 x 10 that is cut by these traces. more: fields after the id.
  Outcome check(const std::string& traces, const std::string& more = "") {
    folder_.write("traces.csv", traces);
    std::string deck = preliminary();
    deck.replace(0, deck.find('\n'), "START, 500, 100");
    folder_.write("a.deck", deck + "OUTLINE, 4, 1\n-5, -5, 5, 5\n-5, 5, 5, -5\n" +
                                "TRACES, traces.csv, 1" + more + "\nCUT\nCYCLE, 1\n");
    return blocks("check a.deck", folder_.path());
  }
  TemporaryFolder folder_;
};

/// Traces across the square, and short ones between them, whose ends are far from all
/// others. The number of loose ends is twice that of the short ones.
std::string traces_with_loose_ends(int number) {
  std::string text = "-5,0,5,0\n";
  for (int k = 0; k < number; ++k)
    text += fmt::format("{0},2,{0},3\n", -4 + 0.5 * k);
  return text;
}

// A trace of length 4.99 stops 0.01 before another one. The mean length of a trace
// is 7.495.
TEST_F(DoubtfulJoints, EndsThatStopJustShortAreWarnedOfWithTheSnapThatJoinsThem) {
  const std::string traces = "-5,0,5,0\n1,5,1,0.01\n";
  const Outcome told = check(traces);
  EXPECT_EQ(told.code, 0);
  EXPECT_THAT(
      told.err,
      HasSubstr(":1: warning: TRACES: 1 loose end stops short of another joint or "
                "of the outline, by 0.01, at (1, 0.01)\n"));
  EXPECT_THAT(told.err, HasSubstr("  hint: give snap 0.011 to prolong it, or snap 0 to "
                                  "leave it loose\n"));
  EXPECT_THAT(told.out, HasSubstr("\n2 blocks (0 fixed)"));
  const Outcome joined = check(traces, ", 0.011");
  EXPECT_THAT(joined.out, HasSubstr("\n3 blocks (0 fixed)"));
  EXPECT_THAT(joined.err, Not(HasSubstr("loose")));
  const Outcome meant = check(traces, ", 0");
  EXPECT_THAT(meant.out, HasSubstr("\n2 blocks (0 fixed)"));
  EXPECT_THAT(meant.out + meant.err, Not(HasSubstr("loose")));
}

// One of three loose ends is a quarter or more, one of five is not.
TEST_F(DoubtfulJoints, FewEndsThatStopShortAreOnlyNoted) {
  const std::string end = "1,5,1,0.01\n";
  EXPECT_THAT(check(traces_with_loose_ends(1) + end).err,
              HasSubstr("TRACES: 1 of 3 loose ends stops short"));
  const Outcome noted = check(traces_with_loose_ends(2) + end);
  EXPECT_THAT(noted.err, Not(HasSubstr("loose")));
  EXPECT_THAT(noted.out,
              HasSubstr("TRACES: traces.csv: 1 of 5 loose ends stops short of "
                        "another joint or of the outline, by 0.01, at (1, "
                        "0.01); give snap 0.011 to prolong it"));
}

// A fiftieth of the mean length 7.5 is 0.15.
TEST_F(DoubtfulJoints, EndsThatStopFarFromOthersAreNotMentioned) {
  EXPECT_THAT(check("-5,0,5,0\n1,5,1,0.16\n").err, Not(HasSubstr("loose")));
  EXPECT_THAT(check("-5,0,5,0\n1,5,1,0.14\n").err, HasSubstr("1 loose end stops"));
}

// The exact gap is larger than the double nearest to it, 0.01.
TEST_F(DoubtfulJoints, TheProposedSnapIsNeverTooSmall) {
  const std::string traces = "-5,0,5,0\n1,5,1,0.01000000000000000000001\n";
  ASSERT_THAT(check(traces).err, HasSubstr("give snap 0.011 to"));
  EXPECT_THAT(check(traces, ", 0.01").out, HasSubstr("\n2 blocks (0 fixed)"));
  EXPECT_THAT(check(traces, ", 0.011").out, HasSubstr("\n3 blocks (0 fixed)"));
}

TEST_F(DoubtfulJoints, AnIdThatNoSideHasIsWarnedOf) {
  const std::string joints = "x1,y1,x2,y2,joint\n-5,0,5,0,3\n0,-5,0,5,4\n";
  const Outcome told = check(joints + "-2,0,3,0,7\n0,1,0,2,9\n");
  EXPECT_EQ(told.code, 0);
  EXPECT_THAT(
      told.err,
      AllOf(HasSubstr(":1: warning: CUT: no side has the joint id 7: its joints "
                      "coincide with others of a smaller id, as at (0.5, 0), or "
                      "with the outline\n"),
            HasSubstr("no side has the joint id 9"),
            HasSubstr("hint: remove them, or give them the smaller id\n")));
  // A part of joint 7 is its own, so its length is in the report.
  const Outcome part = check(joints + "-2,0,3,0,7\n1,-5,1,5,7\n");
  EXPECT_THAT(part.err, Not(HasSubstr("no side has")));
}

// The cell is simple, clockwise and certified, but its second moment is not positive in
// doubles.
TEST_F(DoubtfulJoints, BlocksTooThinToCalculateWithAreLocated) {
  const std::string deck = BLOCKS_SOURCE_DIR
      "/tests/corpus/known_failures/parallel_bundle_below_doubles.deck";
  const Outcome told = blocks("check " + deck, folder_.path());
  EXPECT_EQ(told.code, 3);
  EXPECT_THAT(told.err,
              HasSubstr("error: CUT: block 4 of the cut domain between joints 2, "
                        "3, 9 is too thin to calculate with, at (0, 3)\n"));
  EXPECT_THAT(told.err,
              HasSubstr("hint: give emin and amin, such as 1e-6 of the size of "
                        "a block, or remove one of two joints that nearly "
                        "coincide there\n"));
}

}  // namespace
}  // namespace blocks::testing
