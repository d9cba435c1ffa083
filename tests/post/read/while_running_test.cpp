// Reading the results of a run in progress, and its line of progress.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <optional>

#include "output/results/results_mark.hpp"
#include "output/sample_model.hpp"
#include "post/read/results_reader.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The writer keeps its file open. Commands read the frames published so far.
TEST(WhileRunning, CommandsReadThePublishedFrames) {
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

/// Returns the state of frame i of a row of blocks. Its numbers identify the frame.
Model state(int i) {
  Model model = samples::no_blocks();
  for (int k = 0; k < 300; ++k)
    samples::add_box(model, 2 * k, 0.01 * i, 1, 1);
  model.steps = 10L * i;
  model.time = 0.25 * i;
  model.blocks.spin.setConstant(i + 1);
  for (int k = 0; k < 199; ++k)
    model.contacts.push_back({4 * k + 4, 4 * k + 2, 0.0, 0.0, i + 1.0, 0.0, 0.0});
  return model;
}

/// The number of readings during writing, and of frames that differ from those written.
struct Tally {
  long readings = 0, wrong = 0;
};

Tally read_until(const std::string& path, const std::function<bool()>& ended) {
  Tally tally;
  while (!ended()) {
    const post::ResultsReader results(path);
    ++tally.readings;
    for (long i = 0; i < results.frames(); ++i) {
      const post::Frame frame = results.frame(i);
      const post::FrameContacts contacts = results.contacts(i);
      const auto n = static_cast<double>(i);
      const bool same =
          frame.size() == 300 && frame.step == 10 * i &&
          (frame.outlines[299][1] - Eigen::Vector2d(598, 0.01 * n + 1)).norm() < 1e-9 &&
          (frame.spin.array() == n + 1).all() && contacts.size() == 199 &&
          (contacts.normal_force.array() == n + 1).all();
      tally.wrong += !same;
    }
  }
  return tally;
}

// A reader must not see an index between two changes of its nodes.
TEST(WhileRunning, ReadersSeeCompleteFramesOnly) {
  const TemporaryFolder folder;
  const std::string path = (folder / "going.vtkhdf").string();
  const pid_t writer = fork();
  if (writer == 0) {
    try {
      output::ResultsWriter results(path, {});
      for (int i = 0; i < 400; ++i) {
        results.write(state(i));
        usleep(2000);
      }
    } catch (...) {
      _exit(1);
    }
    _exit(0);
  }
  while (!folder.holds("going.vtkhdf"))
    usleep(1000);
  int status = -1;
  const Tally tally =
      read_until(path, [&] { return waitpid(writer, &status, WNOHANG) == writer; });
  EXPECT_EQ(status, 0);
  EXPECT_GT(tally.readings, 1);
  EXPECT_EQ(tally.wrong, 0) << "in " << tally.readings << " readings";
  EXPECT_EQ(post::ResultsReader(path).frames(), 400);
}

// One writer is killed within a change of the file, the other one ends normally.
TEST(WhileRunning, ReadersDoNotWaitForADeadWriter) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.vtkhdf").string();
  output::ResultsWriter(path, {}).write(state(0));
  std::optional<output::ChangeMark> mark = output::ChangeMark::find(path);
  mark->begin();
  const output::ChangeWatch watch(path);
  const auto soon = [] {
    return std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
  };
  EXPECT_FALSE(watch.settled(soon()));
  const std::string odd = slurp(path);
  mark.reset();
  EXPECT_EQ(watch.settled(soon()), watch.number());
  std::ofstream(path, std::ios::binary) << odd;  // This is the file after kill -9.
  EXPECT_EQ(watch.number() % 2, 1U);
  EXPECT_EQ(watch.settled(soon()), watch.number());
  EXPECT_EQ(post::ResultsReader(path).frame(0).spin[7], 1);
}

/// Returns what the program writes to standard error on a terminal until it has written
/// `awaited`. The end of its terminal stops it.
std::string on_a_terminal(const TemporaryFolder& folder, const std::string& arguments,
                          const std::string& awaited) {
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
  for (ssize_t n; text.find(awaited) == std::string::npos &&
                  (n = read(terminal, part, sizeof part)) > 0;)
    text.append(part, static_cast<std::size_t>(n));
  close(terminal);
  waitpid(child, nullptr, 0);
  return text;
}

// The line overwrites itself.
TEST(WhileRunning, ProgressIsShownOnATerminalOnly) {
  const TemporaryFolder folder;
  folder.write("long.deck", preliminary() + rectangle(0, 0, 1, 1) +
                                "GRAVITY, 0, -1E-9\nCYCLE, 2000000000\n");
  const std::string line = on_a_terminal(folder, "run long.deck", " left");
  for (const char* part :
       {"\r\033[K[", "step ", " t ", " Ek ", " contacts 0 ", " left"})
    EXPECT_THAT(line, HasSubstr(part));
  const Outcome piped = blocks("run long.deck --time-limit 0.5", folder.path());
  EXPECT_EQ(piped.code, 75);
  EXPECT_THAT(piped.err, Not(HasSubstr("\033")));
  EXPECT_THAT(piped.err, Not(HasSubstr(" left")));
}

}  // namespace
}  // namespace blocks::testing
