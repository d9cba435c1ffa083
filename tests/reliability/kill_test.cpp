// A run is killed with kill -9 at a random moment. Its files can be read, and a run
// that continues from its checkpoint, or starts again, has the bits of the
// uninterrupted run.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>

#include "output/checkpoint/checkpoint.hpp"
#include "post/read/results_reader.hpp"
#include "tools/program.hpp"
#include "tools/stored.hpp"

namespace blocks::testing {
namespace {

/// Requires that results and checkpoints in the folder can be read.
void expect_readable(const TemporaryFolder& folder, const std::string& when) {
  if (folder.holds("a.vtkhdf")) {
    const post::ResultsReader reader((folder / "a.vtkhdf").string());
    for (long i = 0; i < reader.frames(); ++i)
      EXPECT_TRUE(reader.frame(i).centroid.allFinite()) << when;
  }
  output::CheckpointInfo info;
  for (const char* name : {"a.ckpt.h5", "a.ckpt.h5.prev"})
    if (folder.holds(name)) {
      EXPECT_NO_THROW(output::read_checkpoint((folder / name).string(), info))
          << name << ", " << when;
    }
}

std::string layers() {
  return layers_and_loads.substr(0, layers_and_loads.find("STOP")) +
         "HISTORY, 0.0005, ke, y:2-9\nCYCLE, 500\n";
}

/// The same layers, with blocks that split. Blocks that are made after a motion in
/// which others may split have no known numbers.
std::string cracking() {
  std::string deck = layers();
  deck.replace(deck.find("FORCE, 25"), 9, "FORCE, 15");
  deck.replace(deck.find("SETVEL, 3, 5, 60, 60"), 20, "SETVEL, 3, 5, 20, 0");
  return deck.insert(deck.find("GRAVITY"), "CRACK, 1, 2.E4, .1\nCRACK, 2, 2.E4, .1\n");
}

class Killed : public ::testing::TestWithParam<std::string> {};

TEST_P(Killed, AtAnyMomentContinuesWithTheSameBits) {
  const std::string& deck = GetParam();
  const std::string arguments = "run a.deck -q --checkpoint-every 0.004";
  const TemporaryFolder straight;
  straight.write("a.deck", deck);
  const auto began = std::chrono::steady_clock::now();
  ASSERT_EQ(blocks(arguments, straight.path()).code, 0);
  double whole =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const auto wanted = left_by_run(straight.path(), "a");

  const bool all = std::getenv("BLOCKS_THOROUGH") != nullptr;
  const int enough = all ? 200 : 4;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> moment(0.0, 1.0);
  int kills = 0, restarts = 0;
  // Some runs end before their moment, because the machine was slower before.
  for (int trials = 0; kills < enough && trials < 4 * enough; ++trials) {
    const TemporaryFolder folder;
    folder.write("a.deck", deck);
    const double seconds = moment(random) * whole;
    const std::string when = "killed after " + std::to_string(seconds) + " s";
    if (killed(arguments, "a.deck", seconds, SIGKILL, folder.path()) == -1)
      ++kills;
    else
      whole *= 0.8;
    expect_readable(folder, when);
    std::string restart;
    if (folder.holds("a.ckpt.h5")) {
      restart = " --restart a.ckpt.h5";
      ++restarts;
    }
    const Outcome run = blocks(arguments + restart, folder.path());
    ASSERT_EQ(run.code, 0) << run.err << when;
    expect_same(left_by_run(folder.path(), "a"), wanted, when);
  }
  RecordProperty("kills", std::to_string(kills));
  RecordProperty("restarts", std::to_string(restarts));
  EXPECT_EQ(kills, enough);
}

INSTANTIATE_TEST_SUITE_P(Decks, Killed, ::testing::Values(layers(), cracking()),
                         [](const auto& one) {
                           return one.index == 0 ? "Layers" : "Cracks";
                         });

}  // namespace
}  // namespace blocks::testing
