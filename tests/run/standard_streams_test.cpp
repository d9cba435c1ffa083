// Standard output and error may be full, closed, or a pipe without reader. The exit
// code shows it, and the files of a run are complete.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// A row of the table is printed every 0.002.
const std::string falling = preliminary() + rectangle(0, 0, 1, 1) +
                            "GRAVITY, 0, -10\nOUTPUT, 0.002\nCYCLE, 30\n";

/// How the shell shows the end by SIGPIPE.
constexpr int ended_by_sigpipe = 128 + SIGPIPE;

class Streams : public ::testing::Test {
 protected:
  void SetUp() override { folder_.write("a.deck", falling); }

  Outcome run(const std::string& arguments) {
    return blocks(arguments, folder_.path());
  }

  /// Runs `blocks arguments | reader`. The command starts after `true` has ended.
  /// Returns the exit code of blocks.
  Outcome piped(const std::string& arguments, const std::string& reader) {
    Outcome outcome = run("--version >/dev/null; { sleep 0.1; '" BLOCKS_PROGRAM "' " +
                          arguments + "; echo $? >code; } | " + reader);
    outcome.code = std::stoi(slurp(folder_ / "code"));
    return outcome;
  }

  /// Requires that the run has finished and its files are complete.
  void expect_whole(const std::string& name) {
    EXPECT_EQ(summary(folder_, name)["status"], "done") << name;
    EXPECT_TRUE(folder_.holds(name + ".ckpt.h5")) << name;
    const post::ResultsReader reader((folder_ / (name + ".vtkhdf")).string());
    EXPECT_EQ(reader.frame(reader.frames() - 1).size(), 1) << name;
  }

  TemporaryFolder folder_;
};

TEST_F(Streams, FullOutputIsAFileError) {
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

TEST_F(Streams, FullOutputDoesNotEndARun) {
  EXPECT_EQ(run("run a.deck >/dev/full").code, 5);
  expect_whole("a");
}

TEST_F(Streams, FullOutputDoesNotHideOtherExitCodes) {
  EXPECT_EQ(run("run a.deck --set CYLCE.ncycle=4 >/dev/full").code, 3);
  EXPECT_EQ(run("run a.deck --stop-after 3 >/dev/full").code, 75);
}

TEST_F(Streams, FullErrorOutputDoesNotEndARun) {
  EXPECT_EQ(run("run absent.deck 2>/dev/full").code, 5);
  EXPECT_EQ(run("walk 2>/dev/full").code, 2);
  EXPECT_EQ(run("run a.deck 2>/dev/full").code, 0);
  expect_whole("a");
}

// The run lasts longer than its reader. It finishes its files and then ends like a
// filter.
TEST_F(Streams, HeadOfATableDoesNotShortenARun) {
  const Outcome early = piped("run a.deck -o b --set CYCLE.ncycle=100000", "head -n 1");
  EXPECT_THAT(early.out, StartsWith("      step         time"));
  EXPECT_THAT(early.err, Not(HasSubstr("error")));
  EXPECT_EQ(early.code, ended_by_sigpipe);
  EXPECT_EQ(summary(folder_, "b")["steps"], 100000);
  expect_whole("b");
}

TEST_F(Streams, ClosedPipeDoesNotHideOtherExitCodes) {
  EXPECT_EQ(piped("run a.deck -q --stop-after 3 --json", "true").code, 75);
}

TEST_F(Streams, ClosedPipeOfMessagesDoesNotEndARun) {
  folder_.write("w.deck", falling + "STOP\nCYCLE, 5\n");
  ASSERT_NE(run("check w.deck").err, "");
  EXPECT_EQ(piped("run w.deck -v 2>&1 >/dev/null", "true").code, 0);
  expect_whole("w");
}

TEST_F(Streams, ClosedPipeEndsACommandQuietly) {
  ASSERT_EQ(run("run a.deck -q").code, 0);
  for (const char* command :
       {"run a.deck -q --json", "cards", "cards --markdown", "manual deck",
        "manual program", "--help", "check a.deck", "history a.vtkhdf -q y:1",
        "history a.vtkhdf --json", "study contacts --list"}) {
    const Outcome early = piped(command, "true");
    EXPECT_EQ(early.err, "") << command;
    EXPECT_EQ(early.code, ended_by_sigpipe) << command;
  }
  expect_whole("a");
}

TEST_F(Streams, ClosedPipeEndsAFilterWithoutAMessage) {
  const Outcome filter = run("cards --markdown | head -n 1");
  EXPECT_EQ(filter.out, "# Deck reference\n");
  EXPECT_EQ(filter.err, "");
}

// A file must not get the descriptor of a closed stream.
TEST_F(Streams, ClosedStreamsDoNotDamageTheFilesOfARun) {
  EXPECT_EQ(run("run a.deck -o c >&-").code, 5);
  expect_whole("c");
  EXPECT_EQ(run("run a.deck -q -o d <&- >&- 2>&-").code, 0);
  expect_whole("d");
}

}  // namespace
}  // namespace blocks::testing
