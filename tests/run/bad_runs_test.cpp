// Decks that parse but cannot be executed, tests/corpus/bad_run/NAME.deck. The file
// NAME.expected has what `blocks run NAME.deck` prints on standard error.
#include <gtest/gtest.h>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

class BadRun : public ::testing::TestWithParam<fs::path> {};

// Only the model of the deck shows these faults. They are reported before any file is
// written.
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

TEST_P(BadRun, IsRefusedByCheckWithTheSameDiagnostics) {
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

// Without decks the tests above would pass.
TEST(BadRuns, AreFound) { EXPECT_GE(decks_below("tests/corpus/bad_run").size(), 15U); }

TEST(AnticlockwiseCreate, IsWarnedOfOnce) {
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
