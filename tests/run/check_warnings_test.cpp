// What `blocks check` and the start of a run warn of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/program.hpp"

namespace blocks::testing {
namespace {

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

}  // namespace
}  // namespace blocks::testing
