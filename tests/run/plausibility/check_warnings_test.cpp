// What `blocks check` and the start of a run warn of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CheckWarnings : public ::testing::Test {
 protected:
  /// Returns what `blocks check` prints about these cards on standard error.
  std::string warnings_of(const std::string& cards) {
    return warnings_of_deck(preliminary() + cards);
  }
  std::string warnings_of_deck(const std::string& deck) {
    folder_.write("small.deck", deck);
    const Outcome check = blocks("check small.deck", folder_.path());
    EXPECT_EQ(check.code, 0) << check.err;
    return check.err;
  }
  TemporaryFolder folder_;
};

TEST_F(CheckWarnings, CountAndNameBlocksOutsideTheDomain) {
  const std::string told =
      warnings_of("CLOOP, 5, 3, 0\nCREATE, 4, 1\n0, 0, 1, 1\n0, 1, 1, 0\n" +
                  rectangle(0, 9.5, 1, 10.5) + "MOTION, 0.1\n");
  EXPECT_THAT(told, HasSubstr("small.deck:3:1: warning: XLIMITS: 1 block outside the "
                              "domain will be fixed: 5\n"));
  EXPECT_THAT(told, HasSubstr("block 5 (CREATE in line 13) reaches x = 13, and xmax is "
                              "10"));
  EXPECT_THAT(told, HasSubstr("warning: YLIMITS: 1 block outside the domain will be "
                              "fixed: 6\n"));
}

TEST_F(CheckWarnings, TellUnitsThatCannotBeConverted) {
  const auto warnings_of_units = [&](const std::string& units) {
    std::string deck = preliminary() + rectangle(0, 0, 1, 1) + "MOTION, 0.1\n";
    deck.insert(deck.find("\nEND\n") + 1, "UNITS, " + units + "\n");
    return warnings_of_deck(deck);
  };
  EXPECT_EQ(warnings_of_units("mm, t, ms"), "");
  const std::string swapped = warnings_of_units("kg, m, s");
  EXPECT_THAT(swapped,
              AllOf(HasSubstr("warning: UNITS: kg is a unit of mass, not of length\n"),
                    HasSubstr("warning: UNITS: m is a unit of length, not of mass\n"),
                    HasSubstr("2 warnings\n")));
  EXPECT_THAT(
      warnings_of_units("m, kg, banana"),
      AllOf(HasSubstr("banana is no known unit, so --units cannot convert it\n"),
            HasSubstr("hint: known units of time: s, ms, us, min, h, d, yr\n1 warn")));
}

TEST_F(CheckWarnings, NameRowsOfBlocksOutsideTheDomainAsRanges) {
  EXPECT_THAT(warnings_of("CLOOP, 4, 3, 0\nCREATE, 4, 1\n8, 8, 9, 9\n0, 1, 1, 0\n"
                          "MOTION, 0.1\n"),
              HasSubstr("3 blocks outside the domain will be fixed: 2 to 4\n"));
}

TEST_F(CheckWarnings, DoNotMentionFixedBlocksOutsideTheDomain) {
  EXPECT_THAT(warnings_of(rectangle(0, 0, 1, 1) + rectangle(9, 0, 11, 1, true) +
                          "MOTION, 0.1\n"),
              Not(HasSubstr("domain")));
}

// The blocks made after a motion are where the deck puts them.
TEST_F(CheckWarnings, NameBlocksOutsideTheDomainThatAreMadeAfterAMotion) {
  EXPECT_THAT(warnings_of(rectangle(0, 0, 1, 1) + "MOTION, 0.1\n" +
                          rectangle(9, 0, 11, 1) + "MOTION, 0.1\n"),
              HasSubstr("XLIMITS: 1 block outside the domain will be fixed: 2\n"));
}

TEST_F(CheckWarnings, AreToldOnceByARun) {
  const Outcome run = run_text(folder_, "out",
                               preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 1\n" +
                                   rectangle(9, 0, 11, 1) + "CYCLE, 1\n");
  const std::string what = "outside the domain will be fixed";
  const auto first = run.err.find(what);
  ASSERT_NE(first, std::string::npos) << run.err;
  EXPECT_EQ(run.err.find(what, first + 1), std::string::npos) << run.err;
}

/// Returns the preliminary cards with this stiffness in place of 1.E7.
std::string with_stiffness(const std::string& stiffness) {
  std::string cards = preliminary();
  cards.replace(cards.find("1.E7, 1.E7"), 10, stiffness + ", " + stiffness);
  return cards;
}

// A unit square weighs 10 kN. Two of them press springs of 1e5 N/m in by 0.2 m.
TEST_F(CheckWarnings, BlameStiffIfTheBlocksAreTooHeavyForIt) {
  const std::string pile = rectangle(0, -1, 1, 0, true) + rectangle(0, 0, 1, 1) +
                           rectangle(0, 1, 1, 2) + "GRAVITY, 0, -10\nMOTION, 0.1\n";
  EXPECT_THAT(
      warnings_of_deck(with_stiffness("1.E5") + pile),
      AllOf(HasSubstr("small.deck:6:8: warning: STIFF: the contacts are too soft "
                      "for the weight of the blocks: at rest block 2 overlaps its "
                      "support by about W/Kn = 0.2, and its width is 1\n"),
            HasSubstr("W = 2e+04 is the weight of the heaviest column; stifn = "
                      "2e+06 makes the overlap 1 % of the block")));
  EXPECT_EQ(warnings_of_deck(with_stiffness("1.E7") + pile), "");
}

TEST_F(CheckWarnings, AddTheWeightsOfOneColumnOnly) {
  EXPECT_EQ(
      warnings_of_deck(with_stiffness("5.E5") +
                       "CLOOP, 8, 1, 0\nCREATE, 4, 1\n-5, -5, -4, -4\n0, 1, 1, 0\n"
                       "GRAVITY, 0, -10\nMOTION, 0.1\n"),
      "");
}

TEST_F(CheckWarnings, BlameATooLargeContactTolerance) {
  EXPECT_THAT(warnings_of(rectangle(0, 0, 0.08, 1) + "MOTION, 0.1\n"),
              AllOf(HasSubstr("warning: BOXES: ctol = 0.1 is more than the width of "
                              "block 1, 0.08\n"),
                    HasSubstr("a good ctol is a tenth of a block: 0.008\n")));
  EXPECT_EQ(warnings_of(rectangle(0, 0, 0.12, 1) + "MOTION, 0.1\n"), "");
}

TEST_F(CheckWarnings, BlameFrictionGivenInDegrees) {
  EXPECT_THAT(
      warnings_of(rectangle(0, 0, 1, 1) + "FRICTN, 30\nMOTION, 0.1\n"),
      HasSubstr("warning: FRICTN: the friction coefficient 30 is very large\n"));
  EXPECT_EQ(warnings_of(rectangle(0, 0, 1, 1) + "FRICTN, 5\nMOTION, 0.1\n"), "");
}

TEST_F(CheckWarnings, TellOfADeckWithoutMotion) {
  EXPECT_THAT(
      warnings_of(rectangle(0, 0, 1, 1) + "STOP\n"),
      HasSubstr("warning: STOP: the deck has no MOTION, CYCLE or SOLVE, so a run makes "
                "no step\n"));
}

TEST_F(CheckWarnings, BlameOverlapsOnTheCardsThatMadeTheBlocks) {
  EXPECT_THAT(
      warnings_of(rectangle(0, 0, 1, 1) + rectangle(0.5, 0, 1.5, 1) + "MOTION, 0.1\n"),
      AllOf(HasSubstr("small.deck:15:1: warning: CREATE: blocks 1 and 2 overlap"),
            HasSubstr("hint: block 1 is made by CREATE in line 12; an overlap at "
                      "the start carries no force")));
}

}  // namespace
}  // namespace blocks::testing
