// A run that cannot continue from a checkpoint is refused with the reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <future>
#include <map>

#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

/// Returns the content of every file in a folder by its name.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[entry.path().filename().string()] = slurp(entry.path());
  return files;
}

TEST(Resumed, WithAnotherDeckOrOptionsIsRefused) {
  const TemporaryFolder folder;
  const std::string deck = preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 9\n";
  folder.write("one.deck", deck);
  folder.write("two.deck", deck + "CYCLE, 1\n");
  ASSERT_EQ(blocks("run one.deck --stop-after 3", folder.path()).code, 75);
  const std::string listing = slurp(folder / "one.out");
  const auto refusal = [&](const std::string& arguments) {
    const Outcome run = blocks("run " + arguments, folder.path());
    EXPECT_EQ(run.code, 5) << arguments;
    return run.err;
  };
  EXPECT_EQ(refusal("two.deck --restart one.ckpt.h5"),
            "blocks: error: cannot continue two.deck from one.ckpt.h5: the checkpoint "
            "belongs to another deck, one.deck 'A SMALL PROBLEM'; use that deck, or "
            "one that begins with RESTART\n");
  EXPECT_EQ(refusal("one.deck --restart one.ckpt.h5 --set CYCLE.ncycle=8"),
            "blocks: error: cannot continue one.deck from one.ckpt.h5: it was written "
            "without --set options\n");
  EXPECT_THAT(refusal("one.deck --restart one.ckpt.h5 --seed 5"),
              HasSubstr("its seed is "));
  EXPECT_FALSE(folder.holds("two.out"));
  folder.write("one.deck", deck + "$ a remark\n");
  EXPECT_EQ(
      refusal("one.deck --restart one.ckpt.h5"),
      "blocks: error: cannot continue one.deck from one.ckpt.h5: the deck has changed "
      "since then, or another deck has the same name; they first differ in line " +
          std::to_string(1 + std::count(deck.begin(), deck.end(), '\n')) + "\n");
  EXPECT_EQ(slurp(folder / "one.out"), listing) << "a refusal touches nothing";
}

// A refused run changes no file. Under another name the run begins new files.
TEST(Resumed, WithDamagedFilesOfItsOwnIsRefused) {
  const TemporaryFolder folder;
  folder.write("own.deck", preliminary() + rectangle(0, 0, 1, 1) +
                               "PLOTS, 1e-9\nOUTPUT, 1e-9, 1\nCYCLE, 20\n");
  const std::string listing = (folder / "own.out").string(),
                    results = (folder / "own.vtkhdf").string();
  const auto damage = [&](const std::string& path, std::uintmax_t bytes) {
    return [path, bytes] {
      bytes == 0 ? static_cast<void>(fs::remove(path)) : fs::resize_file(path, bytes);
    };
  };
  const auto no_frames = [&] {  // The results are of another run of the same deck.
    const TemporaryFolder other;
    fs::copy_file(folder / "own.deck", other / "own.deck");
    ASSERT_EQ(blocks("run own.deck", other.path()).code, 0);
    fs::copy_file(other / "own.vtkhdf", results, fs::copy_options::overwrite_existing);
  };
  struct Case {
    std::function<void()> spoil;
    std::string reason;
  };
  for (const auto& [spoil, reason] :
       {Case{damage(listing, 0), "own.out: it does not exist; use --restart "
                                 "own.ckpt.h5 -o NAME for new files"},
        Case{damage(listing, 900), "own.out: it has 900 bytes, but "},
        Case{damage(results, 3000), "own.vtkhdf: "},
        Case{no_frames,
             "own.vtkhdf: another run wrote it, not that of the checkpoint"}}) {
    ASSERT_EQ(blocks("run own.deck --stop-after 9", folder.path()).code, 75);
    spoil();
    const auto before = contents(folder.path());
    const Outcome refused = blocks("run own.deck --restart own.ckpt.h5", folder.path());
    EXPECT_EQ(refused.code, 5) << reason;
    EXPECT_THAT(refused.err, HasSubstr("blocks: error: cannot continue " + reason));
    EXPECT_EQ(contents(folder.path()), before) << reason;
    EXPECT_EQ(blocks("run own.deck --restart own.ckpt.h5 -o other", folder.path()).code,
              0);
  }
}

TEST(Resumed, WhileAnotherRunWritesIsRefused) {
  const TemporaryFolder folder;
  folder.write("long.deck",
               preliminary() + rectangle(0, 0, 1, 1) + "CYCLE, 9\nCYCLE, 2000000000\n");
  folder.write("other.deck", preliminary() + rectangle(0, 0, 1, 2) + "CYCLE, 9\n");
  ASSERT_EQ(blocks("run long.deck -q --stop-after 5", folder.path()).code, 75);
  // The first run writes checkpoints, which shows that it has begun, until a signal.
  auto first = std::async(std::launch::async, [&] {
    return killed("run long.deck -q --restart long.ckpt.h5 --checkpoint-every 0.01",
                  "refused", 0.0, SIGTERM, folder.path());
  });
  while (!folder.holds("long.ckpt.h5.prev") &&
         first.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
  }
  const Outcome second =
      blocks("run long.deck -q --restart long.ckpt.h5", folder.path());
  const Outcome third = blocks("run other.deck -q -o long", folder.path());
  folder.write("refused", "");
  EXPECT_EQ(first.get(), 130);
  for (const Outcome& run : {second, third}) {
    EXPECT_EQ(run.code, 5);
    EXPECT_THAT(run.err,
                MatchesRegex("blocks: error: cannot write long.vtkhdf: "
                             "another program is writing it \\(process [0-9]+ on "
                             ".*\\); use -o NAME for other files\n"));
  }
}

// The mesh is read after the stop.
TEST(Resumed, WithAnotherMeshIsRefused) {
  const TemporaryFolder folder;
  const auto mesh = [&](const std::string& width) {
    folder.write("m.mesh",
                 "BLOCKS 1\n4, 1\n5 0\n5 1\n" + width + " 1\n" + width + " 0\n");
  };
  mesh("6");
  folder.write("mesh.deck", preliminary() + rectangle(0, 0, 1, 1) +
                                "CYCLE, 10\nREAD9, m.mesh\nCYCLE, 10\n");
  ASSERT_EQ(blocks("run mesh.deck -q --stop-after 5", folder.path()).code, 75);
  mesh("7");
  const Outcome refused =
      blocks("run mesh.deck -q --restart mesh.ckpt.h5", folder.path());
  EXPECT_EQ(refused.code, 5);
  EXPECT_THAT(
      refused.err,
      HasSubstr("a file that READ9, OUTLINE, TRACES or VORONOI reads has changed"));
  mesh("6");
  EXPECT_EQ(blocks("run mesh.deck -q --restart mesh.ckpt.h5", folder.path()).code, 0);
}

}  // namespace
}  // namespace blocks::testing
