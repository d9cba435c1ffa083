// The k-th memory request of the program fails, alone or with all later ones. The
// program ends with a message and exit code 1 or 5, and leaves no incomplete file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "output/checkpoint/checkpoint.hpp"
#include "post/read/results_reader.hpp"
#include "tools/program.hpp"
#include "tools/sanitized.hpp"

namespace blocks::testing {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

struct Case {
  const char* name;
  std::string deck;
};

class FailingMemory : public ::testing::TestWithParam<Case> {};

Outcome run_without_memory(const TemporaryFolder& folder, long fail_at, bool on) {
  setenv("BLOCKS_FAIL_AT", std::to_string(fail_at).c_str(), 1);
  setenv("BLOCKS_COUNT", (folder / "count").c_str(), 1);
  if (on)
    setenv("BLOCKS_FAIL_ON", "1", 1);
  setenv("LD_PRELOAD", BLOCKS_FAILING_MEMORY, 1);
  Outcome run = blocks("run a.deck -q", folder.path());
  unsetenv("LD_PRELOAD");
  unsetenv("BLOCKS_FAIL_ON");
  return run;
}

TEST_P(FailingMemory, IsAnErrorAndLeavesNoIncompleteFile) {
#ifdef BLOCKS_SANITIZED
  GTEST_SKIP() << "sanitizers answer requests for memory themselves";
#endif
  const TemporaryFolder first;
  first.write("a.deck", GetParam().deck);
  const Outcome sound = run_without_memory(first, 0, false);
  ASSERT_EQ(sound.code, 0) << sound.err;
  const long requests = std::stol(slurp(first / "count"));
  ASSERT_GT(requests, 1000);
  const bool all = std::getenv("BLOCKS_THOROUGH") != nullptr;
  const long tries = all ? 300 : 10;
  for (long k = 0; k < tries; ++k) {
    const long at = 1 + (requests - 1) * k / (tries - 1);
    const TemporaryFolder folder;
    folder.write("a.deck", GetParam().deck);
    const Outcome run = run_without_memory(folder, at, k % 2 == 0);
    const std::string when = "request " + std::to_string(at) + " of " +
                             std::to_string(requests) +
                             (k % 2 == 0 ? " and later ones\n" : " only\n");
    if (run.code == 0)
      continue;  // The library did without this memory.
    EXPECT_TRUE(run.code == 1 || run.code == 5) << run.code << ", " << when << run.err;
    EXPECT_THAT(run.err, AnyOf(HasSubstr("not enough memory"),
                               HasSubstr("Cannot allocate memory")))
        << when;
    for (const char* name : {"a.vtkhdf.tmp", "a.ckpt.h5.tmp", "a.summary.json.tmp"})
      EXPECT_FALSE(folder.holds(name)) << name << ", " << when;
    if (folder.holds("a.vtkhdf")) {
      EXPECT_GE(post::ResultsReader((folder / "a.vtkhdf").string()).frames(), 1)
          << when;
    }
    output::CheckpointInfo info;
    if (folder.holds("a.ckpt.h5")) {
      EXPECT_NO_THROW(output::read_checkpoint((folder / "a.ckpt.h5").string(), info))
          << when;
    }
  }
  RecordProperty("tried", std::to_string(tries));
  RecordProperty("requests", std::to_string(requests));
}

const Case cases[] = {
    {"TwoBlocks", preliminary() + rectangle(-5, -1, 5, 0, true) +
                      rectangle(0, 0, 1, 1) +
                      "GRAVITY, 0, -10\nPLOTS, 0.002\nOUTPUT, 0.004\nCYCLE, 20\n"},
    {"Layers", preliminary("SEED, 3\n") +
                   "ORIENT, -15, 15\nMERGE, 0.5\n"
                   "LAYER, -20, 1, -8,-1, -8,0, 8,0, 8,-1, RANDOM\n"
                   "LAYER, -20, 1, -8,0, -8,1, 8,1, 8,0, RANDOM\n"
                   "SPLANE, -8, 5, -8, -5\nGRAVITY, 0, -9.8\nCYCLE, 5\nDUMP\n"},
    {"MotionsBetween", preliminary("FUNCTION, 2\n0, 1\n1, 0\nRIGID\n") +
                           rectangle(-5, -1, 5, 0, true) + rectangle(0, 0, 1, 1) +
                           "PRESSBC, 2, 1, 1, 2\nOUTPUT, 0.002\nCYCLE, 5\n" +
                           rectangle(2, 0, 3, 1) + "FORCE, 3, 1, 2\nMOTION, 0.01\n"}};

INSTANTIATE_TEST_SUITE_P(Decks, FailingMemory, ::testing::ValuesIn(cases),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace blocks::testing
