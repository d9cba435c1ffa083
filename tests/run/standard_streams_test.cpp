// Standard output and error that are full, closed or left by their reader: told by exit
// code and message, and the files of a run are whole all the same.
#include <gtest/gtest.h>

#include "post/results_reader.hpp"
#include "run/program.hpp"

namespace blocks::testing {
namespace {

// Rows of the table every 0.002: one before the steps, several between them.
const std::string falling = preliminary() + rectangle(0, 0, 1, 1) +
                            "GRAVITY, 0, -10\nOUTPUT, 0.002\nCYCLE, 30\n";

class Streams : public ::testing::Test {
 protected:
  void SetUp() override { folder_.write("a.deck", falling); }

  Outcome run(const std::string& arguments) {
    return blocks(arguments, folder_.path());
  }

  /// A finished run of the deck, all four files whole.
  void expect_whole(const std::string& name) {
    EXPECT_EQ(summary(folder_, name)["status"], "done") << name;
    EXPECT_TRUE(folder_.holds(name + ".ckpt.h5")) << name;
    const post::ResultsReader reader((folder_ / (name + ".vtkhdf")).string());
    EXPECT_EQ(reader.frame(reader.frames() - 1).size(), 1) << name;
  }

  TemporaryFolder folder_;
};

TEST_F(Streams, OutputThatIsFullIsAFaultOfAFile) {
  ASSERT_EQ(run("run a.deck -q").code, 0);
  for (const char* command :
       {"cards", "cards --markdown", "manual deck", "--help", "check a.deck",
        "history a.vtkhdf -q y:1", "history a.vtkhdf --json", "study contacts --list",
        "export a.vtkhdf -o a.wkt", "run a.deck -q --json"}) {
    const Outcome full = run(std::string(command) + " >/dev/full");
    EXPECT_EQ(full.code, 5) << command;
    EXPECT_EQ(full.err, "blocks: error: cannot write standard output: No space left on "
                        "device\n")
        << command;
  }
}

TEST_F(Streams, OutputThatIsFullDoesNotEndARun) {
  EXPECT_EQ(run("run a.deck >/dev/full").code, 5);
  expect_whole("a");
}

TEST_F(Streams, AFaultOfTheDeckKeepsItsCode) {
  EXPECT_EQ(run("run a.deck --set CYLCE.ncycle=4 >/dev/full").code, 3);
  EXPECT_EQ(run("run a.deck --stop-after 3 >/dev/full").code, 75);
}

// An exception while printing ended the program with SIGABRT.
TEST_F(Streams, ErrorsThatCannotBeToldKeepARunWhole) {
  EXPECT_EQ(run("run absent.deck 2>/dev/full").code, 5);
  EXPECT_EQ(run("walk 2>/dev/full").code, 2);
  EXPECT_EQ(run("run a.deck 2>/dev/full").code, 0);
  expect_whole("a");
}

// SIGPIPE ended the run: no summary, no checkpoint.
TEST_F(Streams, AReaderThatLeavesDoesNotEndARun) {
  EXPECT_EQ(run("run a.deck -o b | true").code, 0);
  expect_whole("b");
}

// A filter that nobody reads any more ends as others do, without a word.
TEST_F(Streams, AReaderThatLeavesEndsAFilter) {
  const Outcome filter = run("cards --markdown | head -n 1");
  EXPECT_EQ(filter.out, "# Deck reference\n");
  EXPECT_EQ(filter.err, "");
}

// The results got the number of the closed stream, and the table went into them.
TEST_F(Streams, ClosedOnesDoNotSpoilTheFilesOfARun) {
  EXPECT_EQ(run("run a.deck -o c >&-").code, 5);
  expect_whole("c");
  EXPECT_EQ(run("run a.deck -q -o d <&- >&- 2>&-").code, 0);
  expect_whole("d");
}

}  // namespace
}  // namespace blocks::testing
