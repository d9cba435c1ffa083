// The progress line of a run fits the terminal, also after a change of its width. A log
// gets plain lines.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "run/executor/console.hpp"
#include "run/support/progress_line.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using run::progress_line;
using run::RunProgress;
using ::testing::HasSubstr;
using ::testing::Not;

// It would take hours. The end of its terminal stops it.
const std::string endless =
    preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 999999999\n";

winsize columns(int number) { return {24, static_cast<unsigned short>(number), 0, 0}; }

/// A run whose standard error is a terminal.
class RunOnATerminal {
 public:
  explicit RunOnATerminal(int width) {
    folder_.write("a.deck", endless);
    winsize size = columns(width);
    child_ = forkpty(&screen_, nullptr, nullptr, &size);
    if (child_ == 0) {
      if (chdir(folder_.path().c_str()) == 0)
        execl("/bin/sh", "sh", "-c", "exec '" BLOCKS_PROGRAM "' run a.deck >table",
              nullptr);
      _exit(127);
    }
  }
  ~RunOnATerminal() {
    ::close(screen_);
    int status = 0;
    waitpid(child_, &status, 0);
  }
  RunOnATerminal(const RunOnATerminal&) = delete;
  RunOnATerminal& operator=(const RunOnATerminal&) = delete;

  void resize(int width) const {
    winsize size = columns(width);
    ASSERT_EQ(ioctl(screen_, TIOCSWINSZ, &size), 0);
  }
  /// Returns the next progress lines, without the sequence that clears the old one.
  std::vector<std::string> next_lines(std::size_t number) {
    const std::string clear = "\r\033[K";
    std::vector<std::string> lines;
    char bytes[4096];
    while (lines.size() < number) {
      // A line is complete when the next one begins.
      const auto end = seen_.find(clear);
      if (end == std::string::npos) {
        const ssize_t got = read(screen_, bytes, sizeof bytes);
        if (got <= 0)
          return lines;
        seen_.append(bytes, static_cast<std::size_t>(got));
        continue;
      }
      if (seen_.starts_with('['))
        lines.push_back(seen_.substr(0, end));
      seen_.erase(0, end + clear.size());
    }
    return lines;
  }

 private:
  TemporaryFolder folder_;
  std::string seen_;
  int screen_ = -1;
  pid_t child_ = -1;
};

RunProgress half_done() {
  RunProgress run{0.5, 5000.0, 123456789, 0.0125, {}};
  run.totals.kinetic_energy = 1.23456e-12;
  run.totals.active_contacts = 1234567;
  return run;
}

void expect_fits(RunOnATerminal& run, int width) {
  const auto lines = run.next_lines(2);
  ASSERT_EQ(lines.size(), 2U);
  for (const std::string& line : lines) {
    EXPECT_LT(line.size(), static_cast<std::size_t>(width)) << line;
    EXPECT_THAT(line, HasSubstr(" left"));
  }
}

class ProgressLine : public ::testing::TestWithParam<int> {};

TEST_P(ProgressLine, FitsTheTerminal) {
  RunOnATerminal run(GetParam());
  expect_fits(run, GetParam());
}

TEST_P(ProgressLine, FitsLargeNumbers) {
  const std::string line = progress_line(half_done(), GetParam());
  EXPECT_LE(line.size(), static_cast<std::size_t>(GetParam()));
  EXPECT_THAT(line, HasSubstr(" t 0.0125 "));
  EXPECT_THAT(line, HasSubstr(" 1 h 23 min left"));
}

INSTANTIATE_TEST_SUITE_P(Columns, ProgressLine, ::testing::Values(50, 80, 120));

TEST(ProgressLine, FitsATerminalThatIsResized) {
  RunOnATerminal run(120);
  expect_fits(run, 120);
  run.resize(50);
  run.next_lines(2);  // They may have been drawn before the change.
  expect_fits(run, 50);
}

TEST(ProgressLine, HasAllPartsIfThereIsRoom) {
  EXPECT_EQ(progress_line(half_done(), 120),
            "[############............] step 123456789 t 0.0125 Ek 1.23e-12 contacts "
            "1234567 1 h 23 min left");
}

TEST(ProgressLine, IsCutIfNothingElseHelps) {
  EXPECT_EQ(progress_line(half_done(), 9), "[###....]");
  EXPECT_EQ(progress_line(half_done(), 1), "[");
  EXPECT_EQ(progress_line(half_done(), 0), "");
}

TEST(ProgressLog, HasPlainLines) {
  ::testing::internal::CaptureStderr();
  run::Console console(false, false, std::chrono::seconds(0));
  const bool due = console.is_progress_due();
  console.progress(Model(), 0.25);
  console.progress(Model(), 0.5);
  console.clear_progress();
  const std::string log = ::testing::internal::GetCapturedStderr();
  EXPECT_TRUE(due);
  EXPECT_THAT(log, Not(HasSubstr("\r")));
  EXPECT_THAT(log, Not(HasSubstr("\033")));
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 2);
  EXPECT_THAT(log, HasSubstr("\nprogress 50 %: step 0, t 0, Ek 0, contacts 0, "));
}

TEST(ProgressLog, HasNoLineInAShortRun) {
  ::testing::internal::CaptureStderr();
  const run::Console console(false, false);
  const bool due = console.is_progress_due();
  ::testing::internal::GetCapturedStderr();
  EXPECT_FALSE(due);
}

TEST(ProgressLog, IsEmptyIfQuiet) {
  ::testing::internal::CaptureStderr();
  const run::Console console(false, true, std::chrono::seconds(0));
  const bool due = console.is_progress_due();
  ::testing::internal::GetCapturedStderr();
  EXPECT_FALSE(due);
}

}  // namespace
}  // namespace blocks::testing
