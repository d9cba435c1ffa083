// The benchmark program. The tests assert no times.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tools/program.hpp"

namespace blocks {
namespace {

using testing::TemporaryFolder;

int bench(const TemporaryFolder& folder, const std::string& arguments) {
  const std::string command = "cd '" + folder.path().string() +
                              "' && '" BLOCKS_BENCH "' " + arguments +
                              " >out.txt 2>err.txt";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Bench, WritesARowForEveryCodeToJson) {
  const TemporaryFolder folder;
  ASSERT_EQ(
      bench(folder, "--quick --largest 2 --rounds 1 wall search generation seeds"), 0)
      << testing::slurp(folder / "err.txt");
  const auto found = nlohmann::json::parse(testing::slurp(folder / "bench.json"));
  EXPECT_EQ(found.at("quick"), true);
  EXPECT_EQ(found.at("rounds"), 1);
  std::set<std::string> parts, codes, states;
  for (const auto& row : found.at("rows")) {
    parts.insert(row.at("part"));
    codes.insert(row.at("code"));
    states.insert(row.value("state", ""));
    EXPECT_GT(row.at("nanoseconds").get<double>(), 0) << row;
    EXPECT_GE(row.at("threads").get<int>(), 1) << row;
    if (row.contains("ratio")) {
      const auto& ratio = row.at("ratio");
      EXPECT_LE(ratio.at("least"), ratio.at("median")) << row;
      EXPECT_LE(ratio.at("median"), ratio.at("most")) << row;
    }
  }
  EXPECT_EQ(parts, (std::set<std::string>{"wall", "search", "generation", "seeds"}));
  EXPECT_EQ(states, (std::set<std::string>{"", "calm", "chatter"}));
  for (const char* code : {"blocks", "blocks, deformable", "linked lists of 1982"})
    EXPECT_TRUE(codes.contains(code)) << code;
}

TEST(Bench, KeepsAnOlderFile) {
  const TemporaryFolder folder;
  folder.write("bench.json", "mine");
  ASSERT_EQ(bench(folder, "--quick --largest 2 --rounds 1 search"), 0);
  EXPECT_EQ(testing::slurp(folder / "bench.json.bak"), "mine");
}

// A full benchmark takes ten minutes.
TEST(Bench, FindsAMissingFolderBeforeItRuns) {
  const TemporaryFolder folder;
  EXPECT_EQ(bench(folder, "-o nowhere/times"), 5);
  EXPECT_EQ(testing::slurp(folder / "err.txt"),
            "blocks: error: cannot write nowhere/times.md: there is no folder nowhere; "
            "create it with mkdir -p nowhere\n");
}

TEST(Bench, NamesItsPartsIfOneIsUnknown) {
  const TemporaryFolder folder;
  EXPECT_EQ(bench(folder, "wal"), 2);
  EXPECT_EQ(testing::slurp(folder / "err.txt"),
            "blocks: error: no benchmark 'wal'; there are: rock, wall, pile, slope, "
            "crater, subsidence, decks, search, predicates, generation, cut, seeds, "
            "sweeps\n");
}

}  // namespace
}  // namespace blocks
