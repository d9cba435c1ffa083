// Decks that parse but cannot be executed: tests/corpus/bad_run/NAME.deck, what
// `blocks run NAME.deck` prints on standard error, in NAME.expected.
#include <gtest/gtest.h>

#include "run/program.hpp"

namespace blocks::testing {
namespace {

class BadRun : public ::testing::TestWithParam<fs::path> {};

// Faults that only the built model shows are told like faults of the text: place, card,
// reason, hint, all in one pass, and before anything is written.
TEST_P(BadRun, GetsExactlyTheseDiagnostics) {
  auto expected = GetParam();
  expected.replace_extension(".expected");
  const TemporaryFolder folder;
  fs::copy_file(GetParam(), folder.path() / GetParam().filename());
  const Outcome run = blocks("run " + GetParam().filename().string(), folder.path());
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err, slurp(expected));
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1)
      << "a refused deck leaves no file";
}

// `check` says the same as `run`.
TEST_P(BadRun, IsRefusedByCheckAlike) {
  auto expected = GetParam();
  expected.replace_extension(".expected");
  const Outcome check =
      blocks("check " + GetParam().filename().string(), GetParam().parent_path());
  EXPECT_EQ(check.code, 3);
  EXPECT_EQ(check.err, slurp(expected));
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadRun,
                         ::testing::ValuesIn(decks_below("tests/corpus/bad_run")),
                         [](const auto& one) { return one.param.stem().string(); });

// Guards the corpus itself: an empty folder would pass every comparison.
TEST(BadRuns, AreThere) { EXPECT_GE(decks_below("tests/corpus/bad_run").size(), 15U); }

// A block drawn anticlockwise is no fault: it is turned, corner 1 kept, and told once.
TEST(AnticlockwiseCreate, IsAWarningAndTheBlockIsTurned) {
  const TemporaryFolder folder;
  const Outcome run = run_text(folder, "turned",
                               preliminary() + "CREATE, 4, 1\n0, 1, 1, 0\n0, 0, 2, 2\n"
                                               "CYCLE, 1\nDUMP\nSTOP\n");
  EXPECT_EQ(run.err.find("turned.deck:12:1: warning: CREATE: block 1: the corners run "
                         "anticlockwise\n"),
            0U)
      << run.err;
  EXPECT_EQ(summary(folder, "turned")["warnings"].size(), 1U);
}

}  // namespace
}  // namespace blocks::testing
