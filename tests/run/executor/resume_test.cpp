// A run that is stopped and resumed with --restart has the bits of the uninterrupted
// run in state, listing and results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <random>
#include <set>

#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;

/// Runs a deck to its end and stops after each of these steps.
void run_in_parts(const TemporaryFolder& folder, const std::string& arguments,
                  const std::set<long>& stops, const std::string& name) {
  long before = 0;
  std::string restart;
  for (const long stop : stops) {
    const Outcome part = blocks("run " + arguments + restart + " --stop-after " +
                                    std::to_string(stop - before),
                                folder.path());
    ASSERT_EQ(part.code, 75) << part.err;
    restart = " --restart " + name + ".ckpt.h5";
    before = stop;
  }
  const Outcome last = blocks("run " + arguments + restart, folder.path());
  ASSERT_EQ(last.code, 0) << last.err;
}

bool is_thorough() { return std::getenv("BLOCKS_THOROUGH") != nullptr; }

/// Requires that a run stopped at random steps and resumed has the bits of the
/// uninterrupted run. Returns the number of stops.
std::size_t expect_resumable(const fs::path& deck, const std::string& options,
                             int splits) {
  const TemporaryFolder straight, parts;
  const std::string name = deck.stem().string();
  const std::string arguments = "'" + deck.string() + "' -q " + options;
  const Outcome run = blocks("run " + arguments, straight.path());
  EXPECT_EQ(run.code, 0) << run.err;
  if (run.code != 0)
    return 0;
  const long steps = summary(straight, name)["steps"];
  std::mt19937 random(static_cast<unsigned>(std::hash<std::string>()(name)));
  std::set<long> stops;
  while (static_cast<long>(stops.size()) < std::min<long>(splits, steps))
    stops.insert(1 + static_cast<long>(random() % static_cast<unsigned long>(steps)));
  std::string how = name + " stopped after steps";
  for (const long stop : stops)
    how += " " + std::to_string(stop);
  run_in_parts(parts, arguments, stops, name);
  expect_same(left_by_run(parts.path(), name), left_by_run(straight.path(), name), how);
  EXPECT_FALSE(parts.holds(name + ".out.bak")) << how;
  return stops.size();
}

class ResumedDeck : public ::testing::TestWithParam<fs::path> {};

TEST_P(ResumedDeck, HasTheBitsOfTheUninterruptedRun) {
  const int splits = is_thorough() ? 5 : 2;
  const std::string deck = slurp(GetParam());
  const bool large = deck.find("LAYER") != std::string::npos;
  const std::string motion = large ? "--set MOTION.dt=0.004 --set PLOTS.dtplot=0.001 "
                                   : "--set MOTION.dt=0.02 --set PLOTS.dtplot=0.005 ";
  const std::size_t stops =
      expect_resumable(GetParam(),
                       (has_card(deck, "MOTION")  ? motion
                        : has_card(deck, "CYCLE") ? "--set CYCLE.ncycle=300 "
                                                  : std::string()) +
                           fewer_solves(deck),
                       splits);
  RecordProperty("splits", std::to_string(stops));
}

/// Returns the shipped decks. Thorough tests add the decks of problems with known
/// answers and those of other tests.
std::vector<fs::path> decks_to_resume() {
  std::vector<fs::path> decks = decks_below("decks");
  if (is_thorough())
    for (const char* folder : {"validation", "tests/post"}) {
      const std::vector<fs::path> more = decks_below(folder);
      decks.insert(decks.end(), more.begin(), more.end());
    }
  return decks;
}

INSTANTIATE_TEST_SUITE_P(
    Decks, ResumedDeck, ::testing::ValuesIn(decks_to_resume()),
    [](const auto& one) {  // decks/stack/stack becomes decks_stack_stack.
      std::string name =
          fs::relative(one.param, BLOCKS_SOURCE_DIR).replace_extension().string();
      std::replace(name.begin(), name.end(), '/', '_');
      return name;
    });

// The deck has layers, loads, planes, DUMP, warnings and cards between its motions.
TEST(Resumed, DeckWithCardsBetweenMotionsHasTheSameBits) {
  const TemporaryFolder folder;
  folder.write("between.deck", layers_and_loads);
  expect_resumable(folder / "between.deck", "", 5);
  expect_resumable(folder / "between.deck", "--seed 5 --set STIFF.stifn=1.E8", 5);
}

// Gravity is still rising at the stops. A block flies, so the run warns.
TEST(Resumed, DeckWithDampingInARampOfGravityHasTheSameBits) {
  const std::string bricks = rectangle(-5, -1, 5, 0, true) + rectangle(-3, 0, -2, 1) +
                             rectangle(-2.5, 1, -1.5, 2) + rectangle(1, 3, 2, 4);
  const TemporaryFolder folder;
  for (const std::string kind : {"RIGID\n", ""}) {
    folder.write("ramp.deck", preliminary(kind) + bricks +
                                  "GRAVITY, 0, -10, 0.7\nLOCDAMP, .5\n"
                                  "HISTORY, 0.01, energy:artificial, energy:residual\n"
                                  "PLOTS, 0.1\nMOTION, 0.6\nKINDAMP\nMOTION, 0.05\n");
    expect_resumable(folder / "ramp.deck", "", 4);
    const Outcome run = blocks("run ramp.deck", folder.path());
    EXPECT_THAT(run.err, HasSubstr("block 4 flies at time"));
  }
}

// The second card asks for other quantities, the third one for those of the first.
TEST(Resumed, DeckWithHistoriesHasTheSameBits) {
  std::string deck = layers_and_loads;
  const std::string first = "HISTORY, 0.0007, ke, dy:5, y:2-9:p90, overlap\n";
  deck.insert(deck.find("CYCLE, 70"), "HISTORY, 0.002, ke, y:20\n");
  deck.insert(deck.find("SETVEL, 3"), first);
  deck.insert(deck.find("MOTION"), first);
  const TemporaryFolder folder;
  folder.write("histories.deck", deck);
  for (const int splits : {2, 5, 9})
    expect_resumable(folder / "histories.deck", "", splits);
}

// The internal order was chosen before anything moved. A later block changes the order.
TEST(Resumed, WallNumberedAtRandomHasTheSameBits) {
  const TemporaryFolder folder;
  folder.write("wall.deck", wall_at_random() +
                                "PLOTS, 0.001\nOUTPUT, 0.001, 2, 4162\nCYCLE, 15\n"
                                "SETVEL, 4162, 0, 0, -400\n" +
                                rectangle(8.5, 1, 9, 1.5) + "CYCLE, 15\n");
  expect_resumable(folder / "wall.deck", "", 2);
  const Outcome run = blocks("run wall.deck --audit=15", folder.path());
  EXPECT_THAT(run.err, HasSubstr("blocks are renumbered internally"));
  EXPECT_THAT(run.err, HasSubstr("block 4162 moved a corner by"));
  EXPECT_EQ(summary(folder, "wall")["audit"]["faults"], nlohmann::json::array());
  EXPECT_EQ(summary(folder, "wall")["fastest_block"]["block"], 4162);
}

// Arms that turn change their lengths by round-off. The motion bound of a step must use
// the lengths at the latest search also after a restart.
TEST(Resumed, SpinningBlockHasTheSameBits) {
  const TemporaryFolder folder;
  folder.write("spinning.deck", preliminary() + rectangle(0, 0, 1.3, 0.7) +
                                    "SETVEL, 1, 0, 0.1, 0.2, 0.3\nCYCLE, 200\n");
  expect_resumable(folder / "spinning.deck", "", 9);
}

// The run stops at the last step of a card and at the last step of the deck.
TEST(Resumed, BetweenTwoCardsHasTheSameBits) {
  const TemporaryFolder straight, parts;
  for (const TemporaryFolder* folder : {&straight, &parts})
    folder->write("seam.deck",
                  preliminary() + rectangle(0, 0, 1, 1) +
                      "GRAVITY, 0, -10\nCYCLE, 10\nSETVEL, 1, 0, 1\nCYCLE, 10\n");
  ASSERT_EQ(blocks("run seam.deck", straight.path()).code, 0);
  run_in_parts(parts, "seam.deck", {1, 10, 11, 20}, "seam");
  const auto whole = left_by_run(straight.path(), "seam");
  expect_same(left_by_run(parts.path(), "seam"), whole, "seams");
  // The run is at its end, so that another restart changes nothing.
  ASSERT_EQ(blocks("run seam.deck --restart seam.ckpt.h5", parts.path()).code, 0);
  expect_same(left_by_run(parts.path(), "seam"), whole, "again");
}

// A restart deck must not begin again at the checkpoint that it names.
TEST(Resumed, RestartDeckHasTheSameBits) {
  const TemporaryFolder straight, parts;
  for (const TemporaryFolder* folder : {&straight, &parts}) {
    run_text(*folder, "first", layers_and_loads);
    folder->write("second.deck", "RESTART, first.ckpt.h5\nPLOTS, .01\nCYCLE, 30\n"
                                 "LAYER, -9, 2, -8,4, -8,5, 8,5, 8,4, RANDOM\n"
                                 "CYCLE, 30\n");
  }
  ASSERT_EQ(blocks("run second.deck", straight.path()).code, 0);
  run_in_parts(parts, "second.deck", {7, 29, 41}, "second");
  expect_same(left_by_run(parts.path(), "second"),
              left_by_run(straight.path(), "second"), "restart deck");
}

// The run is killed between checkpoints, so that later steps are made again.
TEST(Resumed, AfterAKillHasTheSameBits) {
  const TemporaryFolder straight, parts;
  const std::string deck =
      layers_and_loads.substr(0, layers_and_loads.find("STOP")) + "CYCLE, 2000\n";
  for (const TemporaryFolder* folder : {&straight, &parts})
    folder->write("killed.deck", deck);
  ASSERT_EQ(blocks("run killed.deck", straight.path()).code, 0);
  std::string restart;
  int kills = 0;
  for (double seconds : {0.005, 0.02, 0.03}) {
    kills += killed("run killed.deck --checkpoint-every 0.005" + restart,
                    "killed.ckpt.h5", seconds, SIGKILL, parts.path()) == -1;
    restart = " --restart killed.ckpt.h5";
  }
  EXPECT_GT(kills, 0) << "the run was over before it could be killed";
  ASSERT_EQ(blocks("run killed.deck" + restart, parts.path()).code, 0);
  expect_same(left_by_run(parts.path(), "killed"),
              left_by_run(straight.path(), "killed"), "killed");
}

// After SIGINT, SIGTERM, SIGHUP (130) and a time limit (75) the program finishes the
// step and writes a checkpoint.
TEST(Resumed, AfterASignalOrATimeLimitHasTheSameBits) {
  const TemporaryFolder straight, parts;
  const std::string deck =
      layers_and_loads.substr(0, layers_and_loads.find("STOP")) + "CYCLE, 20000\n";
  for (const TemporaryFolder* folder : {&straight, &parts})
    folder->write("signal.deck", deck);
  ASSERT_EQ(blocks("run signal.deck", straight.path()).code, 0);
  EXPECT_EQ(killed("run signal.deck", "signal.vtkhdf", 0.02, SIGINT, parts.path()),
            130);
  EXPECT_EQ(summary(parts, "signal")["status"], "interrupted");
  EXPECT_EQ(killed("run signal.deck --restart signal.ckpt.h5 --checkpoint-every 0.001",
                   "signal.ckpt.h5.prev", 0.0, SIGTERM, parts.path()),
            130);
  fs::remove(parts / "signal.ckpt.h5.prev");
  EXPECT_EQ(killed("run signal.deck --restart signal.ckpt.h5 --checkpoint-every 0.001",
                   "signal.ckpt.h5.prev", 0.0, SIGHUP, parts.path()),
            130);
  EXPECT_EQ(
      blocks("run signal.deck --restart signal.ckpt.h5 --time-limit 0.02", parts.path())
          .code,
      75);
  EXPECT_EQ(summary(parts, "signal")["status"], "time limit");
  ASSERT_EQ(blocks("run signal.deck --restart signal.ckpt.h5", parts.path()).code, 0);
  expect_same(left_by_run(parts.path(), "signal"),
              left_by_run(straight.path(), "signal"), "signals");
}

// The deck of the hint continues the run for as long again.
TEST(Resumed, AfterItsEndShowsADeckThatContinues) {
  const TemporaryFolder folder;
  const std::string deck = preliminary() + rectangle(0, 0, 1, 1) +
                           "GRAVITY, 0, -10\nMOTION, 0.002\nMOTION, 0.002\n";
  run_text(folder, "a", deck);
  const auto before = summary(folder, "a");
  const Outcome again = blocks("run a.deck --restart a.ckpt.h5", folder.path());
  EXPECT_EQ(again.code, 0);
  EXPECT_EQ(summary(folder, "a")["state_hash"], before["state_hash"]);
  const std::string begin =
      "the run of a.ckpt.h5 is finished; nothing remains to be done\n  hint: --until "
      "0.008 continues it to that time; for new cards, run a deck of these lines in "
      "its "
      "folder\n";
  const auto at = again.err.find(begin);
  ASSERT_NE(at, std::string::npos) << again.err;
  const std::string lines = "    RESTART, a.ckpt.h5\n    MOTION, 0.004\n    STOP\n";
  EXPECT_EQ(again.err.substr(at + begin.size(), lines.size()), lines);
  run_text(folder, "more", lines);
  EXPECT_EQ(summary(folder, "more")["steps"], 2 * before["steps"].get<long>());
}

TEST(Resumed, BeforeItsEndShowsNoOtherDeck) {
  const TemporaryFolder folder;
  folder.write("a.deck", preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 9\n");
  ASSERT_EQ(blocks("run a.deck --stop-after 3", folder.path()).code, 75);
  const Outcome rest = blocks("run a.deck --restart a.ckpt.h5", folder.path());
  EXPECT_EQ(rest.code, 0);
  EXPECT_EQ(rest.err.find("is finished"), std::string::npos) << rest.err;
}

// The command that a stopped run prints can be copied into a shell.
TEST(Resumed, ByThePrintedCommandHasTheSameOptions) {
  const TemporaryFolder folder;
  folder.write("it's a.deck", preliminary() + "READ9\nCYCLE, 9\n");
  folder.write("my mesh.txt", "BLOCKS 1\n4, 1\n0 0\n0 1\n1 1\n1 0\n");
  const Outcome part =
      blocks("run \"it's a.deck\" --set 'MATERIAL[2].rho=3000' --set CYCLE.ncycle=8 "
             "--seed 5 --tape9 'my mesh.txt' -o 'new folder/x y' --until 0.01 "
             "--stop-after 7",
             folder.path());
  ASSERT_EQ(part.code, 75) << part.err;
  const std::string begin = "1 step of this card remains; to continue: blocks ";
  const auto at = part.err.find(begin);
  ASSERT_NE(at, std::string::npos) << part.err;
  const std::string command = part.err.substr(at + begin.size());
  const Outcome rest = blocks(command.substr(0, command.find('\n')), folder.path());
  EXPECT_EQ(rest.code, 0) << rest.err;
  EXPECT_NEAR(summary(folder, "new folder/x y")["time"], 0.01, 0.0004);
}

// The files are named by other paths to their folder.
TEST(Resumed, FromWithinItsFolderHasTheSameBits) {
  const TemporaryFolder straight, parts;
  for (const TemporaryFolder* folder : {&straight, &parts}) {
    folder->write("way.deck",
                  preliminary() + rectangle(0, 0, 1, 1) + "PLOTS, 1e-9\nCYCLE, 20\n");
    fs::create_directory(*folder / "sub");
  }
  ASSERT_EQ(blocks("run way.deck -o sub/", straight.path()).code, 0);
  ASSERT_EQ(blocks("run way.deck -o sub/ --stop-after 9", parts.path()).code, 75);
  ASSERT_EQ(
      blocks("run ../way.deck --restart ./way.ckpt.h5 --stop-after 4", parts / "sub")
          .code,
      75);
  ASSERT_EQ(blocks("run way.deck -o sub/ --restart sub/way.ckpt.h5", parts.path()).code,
            0);
  expect_same(left_by_run(parts / "sub", "way"), left_by_run(straight / "sub", "way"),
              "sub");
  EXPECT_FALSE(fs::exists(parts / "sub/way.vtkhdf.bak"));
}

}  // namespace
}  // namespace blocks::testing
