// Looking at a run that is still going: its results file, and the line that says how
// far it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "output/sample_model.hpp"
#include "run/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The writer holds its file open; every command sees the frames published so far.
TEST(WhileRunning, ResultsCanBeLookedAt) {
  const TemporaryFolder folder;
  Model model = samples::two_blocks();
  output::ResultsWriter writer((folder / "going.vtkhdf").string(), {});
  for (int frame = 1; frame <= 2; ++frame) {
    model.time += 0.25;
    model.steps += 10;
    writer.write(model);
    const Outcome history = blocks("history going.vtkhdf -q step --csv", folder.path());
    ASSERT_EQ(history.code, 0) << history.err;
    EXPECT_EQ(std::count(history.out.begin(), history.out.end(), '\n'), frame + 1);
    for (const char* look : {"view going.vtkhdf", "plot going.vtkhdf --sheet 2",
                             "export going.vtkhdf -o going.pvd"}) {
      const Outcome seen = blocks(look, folder.path());
      EXPECT_EQ(seen.code, 0) << look << "\n" << seen.err;
    }
  }
  EXPECT_EQ(writer.frames(), 2);
}

/// What a run of half a second writes to standard error when that is a terminal.
std::string on_a_terminal(const TemporaryFolder& folder, const std::string& arguments) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    const std::string command =
        "exec '" BLOCKS_PROGRAM "' " + arguments + " > /dev/null";
    if (chdir(folder.path().c_str()) == 0)
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  std::string text;
  char part[1024];
  for (ssize_t n; (n = read(terminal, part, sizeof part)) > 0;)
    text.append(part, static_cast<std::size_t>(n));
  waitpid(child, nullptr, 0);
  close(terminal);
  return text;
}

// One line that is written over, with all that tells a run from a run gone astray.
TEST(WhileRunning, OneLineTellsHowFarItIsOnATerminalOnly) {
  const TemporaryFolder folder;
  folder.write("long.deck", preliminary() + rectangle(0, 0, 1, 1) +
                                "GRAVITY, 0, -1E-9\nCYCLE, 2000000000\n");
  const std::string run = "run long.deck --time-limit 0.5";
  const std::string line = on_a_terminal(folder, run);
  for (const char* part :
       {"\r\033[K[", "step ", " t ", " Ek ", " contacts 0 ", " left"})
    EXPECT_THAT(line, HasSubstr(part));
  const Outcome piped = blocks(run, folder.path());
  EXPECT_EQ(piped.code, 75);
  EXPECT_THAT(piped.err, Not(HasSubstr("\033")));
  EXPECT_THAT(piped.err, Not(HasSubstr(" left")));
}

}  // namespace
}  // namespace blocks::testing
